#include "bt_core/analysis/difference_text.h"

#include <string_view>

namespace coppice {
namespace {

constexpr std::string_view kWrites = "= ";

// A node by its path, a key ("scope{key}") by both of its names.
std::string NameOf(const std::string& what) {
  const std::size_t brace = what.find('{');
  if (brace == std::string::npos || what.back() != '}') return "\"" + what + "\"";
  const std::string key = what.substr(brace + 1, what.size() - brace - 2);
  return "key \"" + key + "\" of \"" + what.substr(0, brace) + "\"";
}

// "returned SUCCESS", "became 5", "was not ticked".
std::string Deed(const std::string& text) {
  if (text.compare(0, 4, "not ") == 0) return "was " + text;
  if (text.compare(0, kWrites.size(), kWrites) == 0) return "became " + text.substr(kWrites.size());
  return "returned " + text;
}

// Both sides, and the verb once if it is the same.
std::string HereAndThere(const std::string& here, const std::string& there) {
  const std::string first = Deed(here);
  std::string second = Deed(there);
  const std::string verb = first.substr(0, first.find(' ') + 1);
  if (verb != "was " && second.compare(0, verb.size(), verb) == 0) second.erase(0, verb.size());
  return first + " here, but " + second + " there";
}

bool IsNothing(const std::string& text) { return text == "nothing more"; }

}  // namespace

std::string Sentence(const RunDifference& difference) {
  std::string text = "In tick " + std::to_string(difference.first_tick) + ", " +
                     NameOf(difference.what) + " " +
                     HereAndThere(difference.first, difference.second);
  if (difference.ticks > 1) {
    text += "; it differs in " + std::to_string(difference.ticks) + " ticks";
  }
  return text;
}

std::string Sentence(const PartingPoint& parting) {
  const std::string text = "The runs diverge in tick " + std::to_string(parting.tick) + ": ";
  const std::string name = NameOf(parting.what);
  if (IsNothing(parting.first)) {
    return text + "there, " + name + " " + Deed(parting.second) + "; here, the tick had ended";
  }
  if (IsNothing(parting.second)) {
    return text + "here, " + name + " " + Deed(parting.first) + "; there, the tick had ended";
  }
  if (!parting.second_what.empty()) {
    return text + "here, " + name + " " + Deed(parting.first) + "; there, " +
           NameOf(parting.second_what) + " " + Deed(parting.second) + " first";
  }
  return text + name + " " + HereAndThere(parting.first, parting.second);
}

}  // namespace coppice
