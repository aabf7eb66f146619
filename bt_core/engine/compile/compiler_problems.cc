#include "bt_core/engine/compile/compiler_problems.h"

#include <utility>

namespace coppice {

void Problems::Add(Severity severity, const Document& document, std::uint32_t offset,
                   std::string message, std::string hint, ProblemSubject about) {
  if (!known_.emplace(&document, offset, message).second) return;
  const auto add = severity == Severity::kError ? &Diagnostics::Error : &Diagnostics::Warning;
  (diagnostics_.*add)(document.Location(offset), std::move(message), std::move(hint),
                      std::move(about));
}

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace coppice
