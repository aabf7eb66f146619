#include "bt_nodes/basics/action_result.h"

namespace coppice {

bool ValueTraits<leaves::ActionResult>::Parse(std::string_view text, leaves::ActionResult& out) {
  const std::size_t blank = text.find(' ');
  const std::string_view word = text.substr(0, blank);
  out.ok = word == "ok";
  out.message = blank == std::string_view::npos ? "" : text.substr(blank + 1);
  return out.ok || word == "failed";
}

std::string ValueTraits<leaves::ActionResult>::Print(const leaves::ActionResult& value) {
  const std::string word = value.ok ? "ok" : "failed";
  return value.message.empty() ? word : word + " " + value.message;
}

}  // namespace coppice
