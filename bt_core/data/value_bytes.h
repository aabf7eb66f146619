// Values as bytes, for events, records and the live view: one byte that says what follows, then the
// value. Numbers, truth values and strings are written without allocation; every other type is its
// JSON. docs/record_format.md is the reference.
#ifndef COPPICE_BT_CORE_DATA_VALUE_BYTES_H_
#define COPPICE_BT_CORE_DATA_VALUE_BYTES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "bt_core/data/value.h"

namespace coppice {

/// What the first byte says; the values are those in files.
enum class ValueForm : std::uint8_t {
  kEmpty = 0,     ///< no value; nothing follows
  kText = 1,      ///< a string: its bytes
  kBool = 2,      ///< one byte
  kSigned = 3,    ///< eight bytes, little endian, two's complement
  kUnsigned = 4,  ///< eight bytes, little endian
  kDouble = 5,    ///< eight bytes, IEEE 754, little endian
  kEnum = 6,      ///< the name of the enumerator
  kJson = 7,      ///< the JSON of any other type
};

/// Appends the bytes of a value. A value whose type cannot write it is the text that says why.
void AppendValueBytes(const Value& value, std::string& out);

/// What bytes stand for: nothing, text (also enumerators and JSON), or a number. Bytes that no
/// value has are read as nothing.
using PlainValue =
    std::variant<std::monostate, std::string, bool, std::int64_t, std::uint64_t, double>;
ValueForm FormOfValue(std::string_view bytes);
PlainValue ReadPlainValue(std::string_view bytes);

/// For people, as Value::Print writes it; empty for no value.
std::string PrintValueBytes(std::string_view bytes);

/// For tools: the text of a JSON value.
std::string ValueBytesToJson(std::string_view bytes);

/// Becomes the value that the bytes stand for. False leaves `out` empty: they stand for no value of
/// the type.
bool ReadValueBytes(std::string_view bytes, const Type& type, Value& out);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_VALUE_BYTES_H_
