#include "bt_core/engine/compile/type_names.h"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/data/standard_types.h"

namespace coppice {
namespace {

// Integers that are smaller than int are kept as int, within their own bounds.
template <class T>
const Type& SmallInteger(const char* name) {
  static const Type type = [name] {
    Type small = TypeOf<int>();
    small.name = name;
    small.parse = [](std::string_view text, void* out) {
      int value = 0;
      const bool fits = ValueTraits<int>::Parse(text, value) &&
                        value >= std::numeric_limits<T>::min() &&
                        value <= std::numeric_limits<T>::max();
      if (fits) *static_cast<int*>(out) = value;
      return fits;
    };
    return small;
  }();
  return type;
}

// Of a type without more than a name; tells it from all others.
bool ParseAnyText(std::string_view text, void* out) {
  *static_cast<std::string*>(out) = text;
  return true;
}

void ReplaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// Removes ", std::allocator<...>" with all that is between the brackets.
void RemoveAllocators(std::string& name) {
  constexpr std::string_view kAllocator = ", std::allocator<";
  for (std::size_t at = name.find(kAllocator); at != name.npos; at = name.find(kAllocator)) {
    std::size_t end = at + kAllocator.size();
    for (int depth = 1; end < name.size() && depth > 0; ++end) {
      depth += name[end] == '<' ? 1 : name[end] == '>' ? -1 : 0;
    }
    name.erase(at, end - at);
  }
}

const Type* FindBasicType(std::string_view name) {
  static const std::pair<std::string_view, const Type*> names[] = {
      {"char", &SmallInteger<signed char>("char")},
      {"signed char", &SmallInteger<signed char>("char")},
      {"int8_t", &SmallInteger<signed char>("char")},
      {"unsigned char", &SmallInteger<unsigned char>("unsigned char")},
      {"uint8_t", &SmallInteger<unsigned char>("unsigned char")},
      {"short", &SmallInteger<short>("short")},
      {"int16_t", &SmallInteger<short>("short")},
      {"unsigned short", &SmallInteger<unsigned short>("unsigned short")},
      {"uint16_t", &SmallInteger<unsigned short>("unsigned short")},
      {"int32_t", &TypeOf<int>()},
      {"uint32_t", &TypeOf<unsigned>()},
      {"long", &TypeOf<std::int64_t>()},
      {"long long", &TypeOf<std::int64_t>()},
      {"unsigned long", &TypeOf<std::uint64_t>()},
      {"unsigned long long", &TypeOf<std::uint64_t>()},
      {"size_t", &TypeOf<std::uint64_t>()},
      {"bool", &TypeOf<bool>()},
      {"int", &TypeOf<int>()},
      {"unsigned", &TypeOf<unsigned>()},
      {"unsigned int", &TypeOf<unsigned>()},
      {"int64", &TypeOf<std::int64_t>()},
      {"int64_t", &TypeOf<std::int64_t>()},
      {"uint64", &TypeOf<std::uint64_t>()},
      {"uint64_t", &TypeOf<std::uint64_t>()},
      {"float", &TypeOf<float>()},
      {"double", &TypeOf<double>()},
      {"string", &TypeOf<std::string>()},
      {"std::string", &TypeOf<std::string>()},
      {"std::vector<int>", &TypeOf<std::vector<int>>()},
      {"std::vector<double>", &TypeOf<std::vector<double>>()},
      {"std::vector<bool>", &TypeOf<std::vector<bool>>()},
      {"std::vector<std::string>", &TypeOf<std::vector<std::string>>()},
      {"Status", &TypeOf<Status>()},
      {"BT::NodeStatus", &TypeOf<Status>()},
  };
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return nullptr;
}

}  // namespace

std::string PlainTypeName(std::string_view name) {
  std::string plain(name);
  ReplaceAll(plain, "std::__cxx11::", "std::");
  ReplaceAll(plain, " >", ">");
  ReplaceAll(plain, "std::basic_string<char, std::char_traits<char>, std::allocator<char>>",
             "std::string");
  RemoveAllocators(plain);
  if (plain.substr(0, 5) == "std::" && FindBasicType(plain.substr(5))) plain.erase(0, 5);
  return plain;
}

NamedType::NamedType(std::string given) : name(std::move(given)), type(TypeOf<std::string>()) {
  type.name = name.c_str();
  type.kind = TypeKind::kOther;
  type.parse = &ParseAnyText;
}

bool HasOnlyAName(const Type& type) { return type.parse == &ParseAnyText; }

const Type* FindType(const Registry& registry, std::string_view given) {
  const std::string name = PlainTypeName(given);
  if (name.empty()) return nullptr;
  if (const Type* basic = FindBasicType(name)) return basic;
  for (const auto& [id, entry] : registry.entries()) {
    for (const PortDeclaration& port : entry.manifest.ports) {
      if (port.type && port.type->name == name && port.type != &TypeOf<ScriptCode>()) {
        return port.type;
      }
    }
  }
  return nullptr;
}

const char* TypeName(const PortDeclaration& port) {
  return port.type ? port.type->name : "BT::AnyTypeAllowed";
}

}  // namespace coppice
