#include "bt_core/script/store.h"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "bt_core/data/enum.h"

namespace coppice::script {
namespace {

using Kind = Operand::Kind;

[[noreturn]] void Refuse(const Operand& operand, const Type& type) {
  throw Failure{Describe(operand) + " is no value of type " + type.name};
}

bool IsNumeric(const Operand& operand) {
  return operand.kind != Kind::kText && operand.kind != Kind::kOther;
}

// False if the number is not kept.
template <class T>
bool StoreInteger(const Operand& operand, Value& value) {
  const Operand number = ToNumber(operand);
  std::int64_t integer = number.integer;
  if (number.kind == Kind::kDouble) {
    constexpr double kEnd = 9223372036854775808.0;
    if (!(number.number >= -kEnd && number.number < kEnd)) return false;
    integer = static_cast<std::int64_t>(number.number);
    if (static_cast<double>(integer) != number.number) return false;
  }
  const T kept = static_cast<T>(integer);
  const bool negative = std::is_unsigned_v<T> && integer < 0;
  if (negative || static_cast<std::int64_t>(kept) != integer) return false;
  value.Set(kept);
  return true;
}

bool StoreBool(const Operand& operand, Value& value) {
  const Operand number = ToNumber(operand);
  const double truth =
      number.kind == Kind::kInteger ? static_cast<double>(number.integer) : number.number;
  if (truth != 0 && truth != 1) return false;
  value.Set(truth == 1);
  return true;
}

template <class T>
bool StoreReal(const Operand& operand, Value& value) {
  const Operand number = ToNumber(operand);
  value.Set(static_cast<T>(number.kind == Kind::kInteger ? number.integer : number.number));
  return true;
}

bool StoreEnumerator(const Operand& operand, const Type& type, Value& value) {
  if (type.enumerators->count == 0) {  // of which only the numbers are known
    return value.Parse(type, std::to_string(ToInteger(operand)));
  }
  const Enumerator* const found = FindEnumerator(*type.enumerators, ToInteger(operand));
  return found && value.Parse(type, found->name);
}

// False if the number is not kept by that type.
bool StoreNumber(const Operand& operand, const Type& type, Value& value) {
  switch (type.kind) {
    case TypeKind::kBool:
      return StoreBool(operand, value);
    case TypeKind::kInt:
      return StoreInteger<int>(operand, value);
    case TypeKind::kUnsigned:
      return StoreInteger<unsigned>(operand, value);
    case TypeKind::kInt64:
      return StoreInteger<std::int64_t>(operand, value);
    case TypeKind::kUint64:
      return StoreInteger<std::uint64_t>(operand, value);
    case TypeKind::kFloat:
      return StoreReal<float>(operand, value);
    case TypeKind::kDouble:
      return StoreReal<double>(operand, value);
    case TypeKind::kEnum:
      return StoreEnumerator(operand, type, value);
    case TypeKind::kString:
    case TypeKind::kOther:
      break;
  }
  return false;
}

// Reuses the storage of a text that is there already.
void StoreText(std::string_view text, Value& value) {
  if (value.Is<std::string>()) {
    value.Get<std::string>().assign(text);
  } else {
    value.Set(std::string(text));
  }
}

void StoreAs(const Type& type, const Operand& operand, Value& value) {
  const bool is_other = operand.kind == Kind::kOther;
  if (is_other && operand.other->type() == &type) {
    value = *operand.other;
    return;
  }
  if (is_other && !IsEnumerator(operand)) Refuse(operand, type);
  if (operand.kind == Kind::kText) {
    if (type.kind == TypeKind::kString) return StoreText(operand.text(), value);
    Value read;
    if (!read.Parse(type, operand.text())) Refuse(operand, type);
    value = std::move(read);
    return;
  }
  if (!StoreNumber(operand, type, value)) Refuse(operand, type);
}

void StoreFirst(const Operand& operand, Value& value) {
  switch (operand.kind) {
    case Kind::kBool:
      return value.Set(operand.truth);
    case Kind::kInteger:
      return value.Set(operand.integer);
    case Kind::kDouble:
      return value.Set(operand.number);
    case Kind::kText:
      return StoreText(operand.text(), value);
    case Kind::kOther:
      value = *operand.other;
      return;
  }
}

bool HasText(const Operand& operand) { return IsNumeric(operand) || IsEnumerator(operand); }

std::string TextOf(const Operand& operand) {
  return operand.kind == Kind::kOther ? operand.other->Print() : Describe(operand);
}

bool Widens(const Operand& operand, const Type& type) {
  const bool from_number = type.kind < TypeKind::kString;
  return from_number && IsNumeric(operand);
}

}  // namespace

void Store(const Operand& operand, const Type* type, Slot& slot, Time now) {
  if (type && type->kind == TypeKind::kString && HasText(operand)) {
    StoreText(TextOf(operand), slot.value);
  } else if (type) {
    StoreAs(*type, operand, slot.value);
  } else if (!slot.value.has_value()) {
    StoreFirst(operand, slot.value);
  } else if (!Widens(operand, *slot.value.type())) {
    StoreAs(*slot.value.type(), operand, slot.value);
  } else if (!StoreNumber(operand, *slot.value.type(), slot.value)) {
    StoreFirst(ToNumber(operand), slot.value);
  }
  slot.CountWrite(now);
}

}  // namespace coppice::script
