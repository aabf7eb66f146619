#include "bt_core/python/values.h"

#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "bt_core/data/standard_types.h"

namespace coppice::python {
namespace {

// What a type is called in Python, for messages.
std::string PythonName(const Type& type) {
  switch (type.kind) {
    case TypeKind::kBool:
      return "bool";
    case TypeKind::kInt:
    case TypeKind::kUnsigned:
    case TypeKind::kInt64:
    case TypeKind::kUint64:
      return "int";
    case TypeKind::kFloat:
    case TypeKind::kDouble:
      return "float";
    case TypeKind::kString:
      return "str";
    default:
      return type.name;
  }
}

std::string Shown(py::handle object) {
  std::string text = py::repr(object);
  constexpr std::size_t kMost = 60;
  if (text.size() > kMost) text = text.substr(0, kMost) + "...";
  return TypeName(object) + " " + text;
}

[[noreturn]] void Refuse(const Type& type, py::handle object) {
  throw py::type_error("expected " + PythonName(type) + ", not " + Shown(object));
}

template <class T>
Value WholeValue(const Type& type, py::handle object) {
  if (PyBool_Check(object.ptr()) || !PyIndex_Check(object.ptr())) Refuse(type, object);
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
  if (!number) throw py::error_already_set();
  try {
    return Value(number.cast<T>());
  } catch (const py::cast_error&) {
    throw py::value_error(std::string(py::str(number)) + " does not fit into " + type.name);
  }
}

template <class T>
Value RealValue(const Type& type, py::handle object) {
  const bool is_number = PyFloat_Check(object.ptr()) || PyIndex_Check(object.ptr()) ||
                         py::hasattr(object, "__float__");
  if (PyBool_Check(object.ptr()) || !is_number) Refuse(type, object);
  const double number = PyFloat_AsDouble(object.ptr());
  if (PyErr_Occurred()) throw py::error_already_set();
  return Value(static_cast<T>(number));
}

template <class T>
Value ListValue(const Type& type, py::handle object) {
  if (PyUnicode_Check(object.ptr()) || !py::isinstance<py::iterable>(object)) Refuse(type, object);
  std::vector<T> list;
  for (const py::handle item : object)
    list.push_back(FromPython(&TypeOf<T>(), item).template Get<T>());
  return Value(list);
}

bool IsDuration(const Type& type) {
  return &type == &TypeOf<std::chrono::nanoseconds>() ||
         &type == &TypeOf<std::chrono::milliseconds>() || &type == &TypeOf<std::chrono::seconds>();
}

py::object TimeDelta(std::chrono::nanoseconds duration) {
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(duration);
  return py::module_::import("datetime")
      .attr("timedelta")(py::arg("microseconds") = microseconds.count());
}

bool IsTimeDelta(py::handle object) {
  return py::isinstance(object, py::module_::import("datetime").attr("timedelta"));
}

std::chrono::nanoseconds FromTimeDelta(py::handle delta) {
  const auto part = [&delta](const char* name) { return delta.attr(name).cast<std::int64_t>(); };
  constexpr std::int64_t kMostDays = 106'000;  // 290 years, in nanoseconds
  if (std::abs(part("days")) > kMostDays) {
    throw py::value_error(std::string(py::str(delta)) + " is more than a duration can be");
  }
  return std::chrono::hours(24) * part("days") + std::chrono::seconds(part("seconds")) +
         std::chrono::microseconds(part("microseconds"));
}

Value DurationValue(const Type& type, py::handle object) {
  std::string text;
  if (IsTimeDelta(object)) {
    text = PrintDuration(FromTimeDelta(object));
  } else if (PyUnicode_Check(object.ptr())) {
    text = object.cast<std::string>();
  } else {
    throw py::type_error("expected datetime.timedelta, not " + Shown(object));
  }
  Value value;
  if (!value.Parse(type, text)) throw py::value_error("\"" + text + "\" is no " + type.name);
  return value;
}

Value EnumValue(const Type& type, py::handle object) {
  Value value;
  if (&type == &TypeOf<Status>() && py::isinstance<Status>(object)) {
    return Value(object.cast<Status>());
  }
  if (!PyUnicode_Check(object.ptr())) Refuse(type, object);
  const std::string text = object.cast<std::string>();
  if (!value.Parse(type, text)) {
    throw py::value_error("\"" + text + "\" is no " + type.name + ": expected " +
                          Choices(*type.enumerators));
  }
  return value;
}

Value ObjectValue(const Type& type, py::handle object) {
  if (!py::isinstance(object, ClassOf(type))) Refuse(type, object);
  const Object held(py::reinterpret_borrow<py::object>(object));
  Value value;
  value.Assign(type, &held);
  return value;
}

Value ForeignValue(const Type& type, py::handle object) {
  Value value;
  if (PyUnicode_Check(object.ptr())) {
    if (value.Parse(type, object.cast<std::string>())) return value;
  } else if (type.has_json_form) {
    const std::string json = py::str(py::module_::import("json").attr("dumps")(object));
    if (value.FromJson(type, json)) return value;
  }
  Refuse(type, object);
}

Value OtherValue(const Type& type, py::handle object) {
  if (HoldsObjects(type)) return ObjectValue(type, object);
  if (IsDuration(type)) return DurationValue(type, object);
  if (&type == &TypeOf<std::vector<double>>()) return ListValue<double>(type, object);
  if (&type == &TypeOf<std::vector<int>>()) return ListValue<int>(type, object);
  if (&type == &TypeOf<std::vector<bool>>()) return ListValue<bool>(type, object);
  if (&type == &TypeOf<std::vector<std::string>>()) return ListValue<std::string>(type, object);
  return ForeignValue(type, object);
}

// What scripts would make of it.
const Type& NaturalType(py::handle object) {
  PyObject* const o = object.ptr();
  if (PyBool_Check(o)) return TypeOf<bool>();
  if (PyUnicode_Check(o)) return TypeOf<std::string>();
  if (PyFloat_Check(o)) return TypeOf<double>();
  if (PyIndex_Check(o)) return TypeOf<std::int64_t>();
  if (py::isinstance<Status>(object)) return TypeOf<Status>();
  if (IsTimeDelta(object)) return TypeOf<std::chrono::nanoseconds>();
  return TypeOf<Object>();
}

py::list TextList(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) list.append(TextOf(text));
  return list;
}

py::object OtherToPython(const Value& value) {
  const Type& type = *value.type();
  if (HoldsObjects(type)) {
    return py::reinterpret_borrow<py::object>(static_cast<const Object*>(value.data())->get());
  }
  if (value.Is<std::chrono::nanoseconds>()) return TimeDelta(value.Get<std::chrono::nanoseconds>());
  if (value.Is<std::chrono::milliseconds>()) {
    return TimeDelta(value.Get<std::chrono::milliseconds>());
  }
  if (value.Is<std::chrono::seconds>()) return TimeDelta(value.Get<std::chrono::seconds>());
  if (value.Is<std::vector<double>>()) return py::cast(value.Get<std::vector<double>>());
  if (value.Is<std::vector<int>>()) return py::cast(value.Get<std::vector<int>>());
  if (value.Is<std::vector<bool>>()) return py::cast(value.Get<std::vector<bool>>());
  if (value.Is<std::vector<std::string>>()) return TextList(value.Get<std::vector<std::string>>());
  if (!type.has_json_form) return TextOf(value.Print());
  return py::module_::import("json").attr("loads")(TextOf(value.ToJson()));
}

// Those that an annotation names by a word.
const Type* NamedType(const std::string& name) {
  static const Type* const kTypes[] = {&TypeOf<bool>(),
                                       &TypeOf<int>(),
                                       &TypeOf<unsigned>(),
                                       &TypeOf<std::int64_t>(),
                                       &TypeOf<std::uint64_t>(),
                                       &TypeOf<float>(),
                                       &TypeOf<double>(),
                                       &TypeOf<std::string>(),
                                       &TypeOf<Status>(),
                                       &TypeOf<std::vector<int>>(),
                                       &TypeOf<std::vector<double>>(),
                                       &TypeOf<std::vector<bool>>(),
                                       &TypeOf<std::vector<std::string>>(),
                                       &TypeOf<std::chrono::nanoseconds>(),
                                       &TypeOf<std::chrono::milliseconds>(),
                                       &TypeOf<std::chrono::seconds>()};
  for (const Type* type : kTypes) {
    if (name == type->name) return type;
  }
  return nullptr;
}

}  // namespace

py::object ToPython(const Value& value) {
  if (!value.has_value()) return py::none();
  switch (value.type()->kind) {
    case TypeKind::kBool:
      return py::bool_(value.Get<bool>());
    case TypeKind::kInt:
      return py::int_(value.Get<int>());
    case TypeKind::kUnsigned:
      return py::int_(value.Get<unsigned>());
    case TypeKind::kInt64:
      return py::int_(value.Get<std::int64_t>());
    case TypeKind::kUint64:
      return py::int_(value.Get<std::uint64_t>());
    case TypeKind::kFloat:
      return py::float_(value.Get<float>());
    case TypeKind::kDouble:
      return py::float_(value.Get<double>());
    case TypeKind::kString:
      return TextOf(value.Get<std::string>());
    case TypeKind::kEnum:
      if (value.Is<Status>()) return py::cast(value.Get<Status>());
      return TextOf(value.Print());
    case TypeKind::kOther:
      break;
  }
  return OtherToPython(value);
}

Value FromPython(const Type* given, py::handle object) {
  const Type& type = given ? *given : NaturalType(object);
  switch (type.kind) {
    case TypeKind::kBool:
      if (!PyBool_Check(object.ptr())) Refuse(type, object);
      return Value(object.ptr() == Py_True);
    case TypeKind::kInt:
      return WholeValue<int>(type, object);
    case TypeKind::kUnsigned:
      return WholeValue<unsigned>(type, object);
    case TypeKind::kInt64:
      return WholeValue<std::int64_t>(type, object);
    case TypeKind::kUint64:
      return WholeValue<std::uint64_t>(type, object);
    case TypeKind::kFloat:
      return RealValue<float>(type, object);
    case TypeKind::kDouble:
      return RealValue<double>(type, object);
    case TypeKind::kString:
      if (!PyUnicode_Check(object.ptr())) Refuse(type, object);
      return Value(object.cast<std::string>());
    case TypeKind::kEnum:
      return EnumValue(type, object);
    case TypeKind::kOther:
      break;
  }
  return OtherValue(type, object);
}

const Type& TypeFromAnnotation(py::handle annotation) {
  if (PyType_Check(annotation.ptr())) {
    return TypeOfClass(py::reinterpret_borrow<py::type>(annotation));
  }
  const std::string name = py::str(annotation);
  if (const Type* type = NamedType(name)) return *type;
  throw py::type_error("no port can be of type " + name);
}

double ToSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }
double ToSeconds(Time time) { return ToSeconds(time.time_since_epoch()); }

Duration FromSeconds(double seconds) {
  constexpr double kMost = 9.2e9;
  if (!(std::abs(seconds) <= kMost)) {
    throw py::value_error(std::to_string(seconds) + " is no time in seconds");
  }
  return Duration(std::llround(seconds * 1e9));
}

}  // namespace coppice::python
