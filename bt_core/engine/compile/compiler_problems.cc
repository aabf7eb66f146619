#include "bt_core/engine/compile/compiler_problems.h"

#include <utility>

namespace coppice {

bool Problems::IsNew(const Document& document, std::uint32_t offset, const std::string& message) {
  return known_.emplace(&document, offset, message).second;
}

void Problems::Error(const Document& document, std::uint32_t offset, std::string message,
                     std::string hint, ProblemSubject about) {
  if (!IsNew(document, offset, message)) return;
  diagnostics_.Error(document.Location(offset), std::move(message), std::move(hint),
                     std::move(about));
}

void Problems::Warning(const Document& document, std::uint32_t offset, std::string message,
                       std::string hint, ProblemSubject about) {
  if (!IsNew(document, offset, message)) return;
  diagnostics_.Warning(document.Location(offset), std::move(message), std::move(hint),
                       std::move(about));
}

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace coppice
