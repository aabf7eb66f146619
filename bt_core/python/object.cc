#include "bt_core/python/object.h"

#include <deque>
#include <mutex>
#include <typeinfo>
#include <utility>
#include <vector>

namespace coppice::python {
namespace {

std::mutex dropped_mutex;
std::vector<PyObject*> dropped;  // to be let go by who has the GIL

void LetGo(PyObject* object) {
  if (!Py_IsInitialized()) return;
  if (PyGILState_Check()) {
    Py_DECREF(object);
    return;
  }
  const std::lock_guard<std::mutex> lock(dropped_mutex);
  dropped.push_back(object);
}

// A type and its class. The type comes first, so that its address is that of the whole.
struct ClassType {
  Type type;
  PyObject* python_class;
  std::string name;
};

// For ever: programs and records point to them.
std::deque<ClassType>& ClassTypes() {
  static auto* const types = new std::deque<ClassType>();
  return *types;
}

}  // namespace

Object::Object(py::object object) : object_(object.release().ptr(), &LetGo) {}

void CollectDropped() {
  std::vector<PyObject*> now;
  {
    const std::lock_guard<std::mutex> lock(dropped_mutex);
    now.swap(dropped);
  }
  for (PyObject* const object : now) Py_DECREF(object);
}

py::str TextOf(std::string_view text) {
  PyObject* const decoded =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (!decoded) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

std::string TypeName(py::handle object) { return Py_TYPE(object.ptr())->tp_name; }

const Type& TypeOfClass(const py::type& type) {
  PyObject* const wanted = type.ptr();
  if (wanted == reinterpret_cast<PyObject*>(&PyBaseObject_Type)) return TypeOf<Object>();
  for (const ClassType& known : ClassTypes()) {
    if (known.python_class == wanted) return known.type;
  }
  Py_INCREF(wanted);
  ClassType& added = ClassTypes().emplace_back(
      ClassType{TypeOf<Object>(), wanted, py::str(type.attr("__qualname__"))});
  added.type.name = added.name.c_str();
  return added.type;
}

py::object ClassOf(const Type& type) {
  if (&type == &TypeOf<Object>()) {
    return py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(&PyBaseObject_Type));
  }
  for (const ClassType& known : ClassTypes()) {
    if (&known.type == &type) return py::reinterpret_borrow<py::object>(known.python_class);
  }
  return {};
}

bool HoldsObjects(const Type& type) { return *type.info == typeid(Object); }

}  // namespace coppice::python

namespace coppice {

bool ValueTraits<python::Object>::Parse(std::string_view, python::Object&) { return false; }

std::string ValueTraits<python::Object>::Print(const python::Object& value) {
  if (!value) return {};
  const pybind11::gil_scoped_acquire gil;
  try {
    return pybind11::repr(value.get());
  } catch (pybind11::error_already_set& error) {
    return "<" + python::TypeName(value.get()) + " whose repr() fails>";
  }
}

}  // namespace coppice
