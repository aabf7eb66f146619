// An object of Python that C++ may hold, copy and let go on any thread, with or without the GIL.
//
// What is let go without the GIL is kept until somebody has it: nothing here ever waits for the
// GIL, so it may happen under any lock. After the end of the interpreter objects are left alone.
#ifndef COPPICE_BT_CORE_PYTHON_OBJECT_H_
#define COPPICE_BT_CORE_PYTHON_OBJECT_H_

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <string_view>

#include "bt_core/data/type.h"

namespace coppice::python {

namespace py = pybind11;

class Object {
 public:
  Object() = default;
  /// With the GIL.
  explicit Object(py::object object);

  /// Null if there is none. What is done with it needs the GIL.
  py::handle get() const { return object_.get(); }
  explicit operator bool() const { return object_ != nullptr; }

 private:
  std::shared_ptr<PyObject> object_;
};

/// With the GIL: lets go what was dropped without it.
void CollectDropped();

/// A text of C++; what is no UTF-8 in it is replaced. With the GIL.
py::str TextOf(std::string_view text);

/// "IsDark", "list": the name of the type of an object, for messages. With the GIL.
std::string TypeName(py::handle object);

/// The type of ports and keys that hold objects of this class: one for each class, as long as the
/// program runs. `object` itself stands for all. With the GIL.
const Type& TypeOfClass(const py::type& type);

/// The class whose objects a type stands for; empty if the type is none of TypeOfClass.
py::object ClassOf(const Type& type);

/// True for the types of TypeOfClass.
bool HoldsObjects(const Type& type);

}  // namespace coppice::python

namespace coppice {

/// Such a value is written by repr(), and cannot be read from a text.
template <>
struct ValueTraits<python::Object> {
  static constexpr const char* kName = "object";
  static bool Parse(std::string_view text, python::Object& out);
  static std::string Print(const python::Object& value);
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_PYTHON_OBJECT_H_
