#include "bt_core/data/value_bytes.h"

#include <cstring>
#include <exception>

#include "bt_core/data/json.h"
#include "bt_core/data/standard_types.h"

namespace coppice {
namespace {

void Number(ValueForm form, std::uint64_t bits, std::string& out) {
  char bytes[9] = {static_cast<char>(form)};
  for (int i = 0; i < 8; ++i) bytes[i + 1] = static_cast<char>(bits >> (8 * i) & 0xff);
  out.append(bytes, sizeof bytes);
}

void Text(ValueForm form, std::string_view text, std::string& out) {
  out += static_cast<char>(form);
  out += text;
}

std::uint64_t Bits(double number) {
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

std::uint64_t ReadNumber(std::string_view payload) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(payload[i]);
  return bits;
}

double ReadDouble(std::string_view payload) {
  const std::uint64_t bits = ReadNumber(payload);
  double number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

void AppendOther(const Value& value, std::string& out) {
  try {
    if (value.type()->kind == TypeKind::kEnum) {
      Text(ValueForm::kEnum, value.Print(), out);
    } else {
      Text(ValueForm::kJson, value.ToJson(), out);
    }
  } catch (const std::exception& error) {
    Text(ValueForm::kText, std::string("cannot be written: ") + error.what(), out);
  }
}

}  // namespace

void AppendValueBytes(const Value& value, std::string& out) {
  if (!value.has_value()) {
    out += static_cast<char>(ValueForm::kEmpty);
    return;
  }
  switch (value.type()->kind) {
    case TypeKind::kBool:
      out += static_cast<char>(ValueForm::kBool);
      out += static_cast<char>(value.Get<bool>());
      return;
    case TypeKind::kInt:
      return Number(ValueForm::kSigned, static_cast<std::uint64_t>(value.Get<int>()), out);
    case TypeKind::kInt64:
      return Number(ValueForm::kSigned, static_cast<std::uint64_t>(value.Get<std::int64_t>()), out);
    case TypeKind::kUnsigned:
      return Number(ValueForm::kUnsigned, value.Get<unsigned>(), out);
    case TypeKind::kUint64:
      return Number(ValueForm::kUnsigned, value.Get<std::uint64_t>(), out);
    case TypeKind::kFloat:
      return Number(ValueForm::kDouble, Bits(value.Get<float>()), out);
    case TypeKind::kDouble:
      return Number(ValueForm::kDouble, Bits(value.Get<double>()), out);
    case TypeKind::kString:
      return Text(ValueForm::kText, value.Get<std::string>(), out);
    case TypeKind::kEnum:
    case TypeKind::kOther:
      return AppendOther(value, out);
  }
}

ValueForm FormOfValue(std::string_view bytes) {
  if (bytes.empty()) return ValueForm::kEmpty;
  const auto form = static_cast<ValueForm>(bytes[0]);
  switch (form) {
    case ValueForm::kText:
    case ValueForm::kEnum:
    case ValueForm::kJson:
      return form;
    case ValueForm::kBool:
      return bytes.size() == 2 ? form : ValueForm::kEmpty;
    case ValueForm::kSigned:
    case ValueForm::kUnsigned:
    case ValueForm::kDouble:
      return bytes.size() == 9 ? form : ValueForm::kEmpty;
    default:
      return ValueForm::kEmpty;
  }
}

PlainValue ReadPlainValue(std::string_view bytes) {
  const ValueForm form = FormOfValue(bytes);
  const std::string_view payload = bytes.substr(bytes.empty() ? 0 : 1);
  switch (form) {
    case ValueForm::kEmpty:
      return {};
    case ValueForm::kBool:
      return payload[0] != 0;
    case ValueForm::kSigned:
      return static_cast<std::int64_t>(ReadNumber(payload));
    case ValueForm::kUnsigned:
      return ReadNumber(payload);
    case ValueForm::kDouble:
      return ReadDouble(payload);
    default:
      return std::string(payload);
  }
}

namespace {

template <class T>
std::string PrintAs(const T& value) {
  return ValueTraits<T>::Print(value);
}
std::string PrintAs(std::monostate) { return {}; }

template <class T>
std::string JsonOf(const T& value) {
  return TypeOf<T>().to_json(&value);
}
std::string JsonOf(std::monostate) { return "null"; }

// Of a number, whatever its size in the type.
template <class T>
bool Assign(const Type& type, const T& number, Value& out) {
  return out.Parse(type, ValueTraits<T>::Print(number));
}

}  // namespace

std::string PrintValueBytes(std::string_view bytes) {
  return std::visit([](const auto& value) { return PrintAs(value); }, ReadPlainValue(bytes));
}

std::string ValueBytesToJson(std::string_view bytes) {
  if (FormOfValue(bytes) == ValueForm::kJson) return std::string(bytes.substr(1));
  return std::visit([](const auto& value) { return JsonOf(value); }, ReadPlainValue(bytes));
}

bool ReadValueBytes(std::string_view bytes, const Type& type, Value& out) {
  const PlainValue plain = ReadPlainValue(bytes);
  if (FormOfValue(bytes) == ValueForm::kJson) {
    return out.FromJson(type, std::get<std::string>(plain));
  }
  out.Reset();
  return std::visit(
      [&](const auto& value) {
        using T = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<T, std::monostate>) {
          return false;
        } else if constexpr (std::is_same_v<T, std::string>) {
          return out.Parse(type, value);
        } else {
          return Assign(type, value, out);
        }
      },
      plain);
}

}  // namespace coppice
