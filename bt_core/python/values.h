// Values of ports and keys as Python has them, and back. All with the GIL.
//
//   bool                           bool
//   int, unsigned, int64, uint64   int
//   float, double                  float
//   string, enumerators            str; Status is coppice.Status
//   lists                          list
//   durations                      datetime.timedelta
//   types with JSON of their own   what json.loads makes of it; other types of C++ are a str
//   TypeOfClass                    the object itself
#ifndef COPPICE_BT_CORE_PYTHON_VALUES_H_
#define COPPICE_BT_CORE_PYTHON_VALUES_H_

#include <pybind11/pybind11.h>

#include <string>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"
#include "bt_core/python/object.h"

namespace coppice::python {

/// None for an empty value.
py::object ToPython(const Value& value);

/// The value of that type; null: of the type that fits the object best. Throws TypeError or
/// ValueError with what was expected. A type of C++ that Python does not have is also read from the
/// text that XML has for it, and one with JSON of its own from dicts and lists.
Value FromPython(const Type* type, py::handle object);

/// The type that an annotation of a port names: a class, or one of the names of type.h ("int64",
/// "list of double", "duration"). Throws TypeError.
const Type& TypeFromAnnotation(py::handle annotation);

/// Seconds, as all functions have them that are about time.
double ToSeconds(Duration duration);
double ToSeconds(Time time);
/// Throws ValueError if it is no number, or more than 292 years.
Duration FromSeconds(double seconds);

}  // namespace coppice::python

#endif  // COPPICE_BT_CORE_PYTHON_VALUES_H_
