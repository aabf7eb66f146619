#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp/json_export.h"

namespace BT {
namespace internal {

using coppice::TypeKind;
using coppice::Value;

namespace {

Number Signed(std::int64_t value) { return {Number::Kind::kSigned, value, 0, 0}; }
Number Unsigned(std::uint64_t value) { return {Number::Kind::kUnsigned, 0, value, 0}; }
Number Real(double value) { return {Number::Kind::kReal, 0, 0, value}; }

}  // namespace

Number NumberOf(const Value& value) {
  if (!value.has_value()) return {};
  switch (value.type()->kind) {
    case TypeKind::kBool:
      return Signed(value.Get<bool>() ? 1 : 0);
    case TypeKind::kInt:
      return Signed(value.Get<int>());
    case TypeKind::kUnsigned:
      return Signed(value.Get<unsigned>());
    case TypeKind::kInt64:
      return Signed(value.Get<std::int64_t>());
    case TypeKind::kUint64:
      return Unsigned(value.Get<std::uint64_t>());
    case TypeKind::kFloat:
      return Real(value.Get<float>());
    case TypeKind::kDouble:
      return Real(value.Get<double>());
    case TypeKind::kEnum:
      return Signed(value.EnumeratorValue());
    case TypeKind::kString:
    case TypeKind::kOther:
      break;
  }
  return {};
}

bool IsText(const Value& value) {
  return value.has_value() && value.type()->kind == TypeKind::kString;
}

std::string TextOf(const Value& value) {
  const Number number = NumberOf(value);
  switch (number.kind) {
    case Number::Kind::kSigned:
      return std::to_string(number.as_signed);
    case Number::Kind::kUnsigned:
      return std::to_string(number.as_unsigned);
    case Number::Kind::kReal:
      return std::to_string(number.as_real);
    case Number::Kind::kNone:
      break;
  }
  return value.Print();
}

namespace {
std::string TypeOfValue(const Value& value) {
  return value.has_value() ? demangle(*value.type()->info) : "nothing";
}
}  // namespace

std::string CannotConvert(const Value& value, const std::type_info& to) {
  return StrCat("[Any::convert]: no known safe conversion between [", TypeOfValue(value), "] and [",
                demangle(to), "]");
}

std::string LosesPrecision(const Value& value, const std::type_info& to) {
  return StrCat("[Any::convert]: ", TextOf(value), " of type [", TypeOfValue(value),
                "] does not fit into [", demangle(to), "]");
}

std::string JsonOf(const Any& value) {
  nlohmann::json json;
  return JsonExporter::get().toJson(value, json) ? json.dump() : "null";
}

}  // namespace internal

const std::type_info& Any::castedType() const noexcept {
  using Kind = internal::Number::Kind;
  switch (internal::NumberOf(value_).kind) {
    case Kind::kSigned:
      return typeid(std::int64_t);
    case Kind::kUnsigned:
      return typeid(std::uint64_t);
    case Kind::kReal:
      return typeid(double);
    case Kind::kNone:
      break;
  }
  return empty() ? typeid(nullptr) : *value_.type()->info;
}

void Any::copyInto(Any& destination) const {
  const bool same = type() == destination.type();
  if (destination.empty() || same) {
    destination = *this;
    return;
  }
  if (!isNumber() || !destination.isNumber()) throw std::runtime_error("Any::copyInto fails");
  coppice::Value converted;
  const coppice::Type& type = *destination.value_.type();
  if (!converted.Parse(type, internal::TextOf(value_)) && !converted.Parse(type, value_.Print())) {
    throw std::runtime_error(internal::LosesPrecision(value_, *type.info));
  }
  destination.value_ = std::move(converted);
}

}  // namespace BT
