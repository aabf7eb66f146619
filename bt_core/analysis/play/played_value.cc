#include "bt_core/analysis/play/played_value.h"

#include <type_traits>
#include <variant>

#include "bt_core/data/value_bytes.h"

namespace coppice {

Value PlayedValue(std::string_view bytes, const Type* type) {
  Value value;
  if (type) {
    ReadValueBytes(bytes, *type, value);
    return value;
  }
  std::visit(
      [&](const auto& content) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(content)>, std::monostate>) {
          value.Set(content);
        }
      },
      ReadPlainValue(bytes));
  return value;
}

}  // namespace coppice
