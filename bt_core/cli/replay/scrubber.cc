#include "bt_core/cli/replay/scrubber.h"

#include <algorithm>
#include <cstdlib>

#include "bt_core/analysis/why/why_text.h"
#include "bt_core/base/json.h"
#include "bt_core/base/plain.h"
#include "bt_core/cli/replay/replay_tree.h"

namespace coppice {
namespace {

constexpr char kHelp[] =
    "left/right h/l: tick   pgup/pgdn: 10   home/end   g: go to tick   t: go to time   "
    "up/down k/j: node   n/N: its next/last change   /: search   w: why   q: quit";
constexpr std::size_t kPage = 10;

// At most so many characters, without counting the escapes of colours, which stand at the ends.
std::string Cut(const std::string& text, std::size_t columns) {
  const bool colored = text.rfind("\x1b[", 0) == 0;
  const std::string line = colored ? text : Plain(text);
  const std::size_t extra = colored ? 9 : 0;
  if (line.size() <= columns + extra) return line;
  return line.substr(0, columns + (colored ? 5 : 0)) + (colored ? "\x1b[0m" : "");
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace

Scrubber::Scrubber(const Recording& run) : run_(run), entry_(run.ticks().size() - 1) {}

const TreeDescription& Scrubber::tree() const { return run_.trees()[run_.TreeOf(entry_)]; }

bool Scrubber::Press(const std::string& key) {
  if (!prompt_.empty()) return PressInPrompt(key);
  message_.clear();
  const auto nodes = static_cast<NodeIndex>(tree().nodes.size());
  if (key == "q" || key == "escape") return false;
  if (key == "left" || key == "h") Move(-1);
  if (key == "right" || key == "l") Move(1);
  if (key == "pageup") Move(-static_cast<std::int64_t>(kPage));
  if (key == "pagedown") Move(kPage);
  if (key == "home") GoTo(0);
  if (key == "end") GoTo(run_.ticks().size() - 1);
  if ((key == "up" || key == "k") && node_ > 0) --node_;
  if ((key == "down" || key == "j") && node_ + 1 < nodes) ++node_;
  if (key == "n") GoToChange(1);
  if (key == "N") GoToChange(-1);
  if (key == "g") prompt_ = "tick";
  if (key == "t") prompt_ = "time";
  if (key == "/") prompt_ = "search";
  if (key == "w") Explain();
  return true;
}

bool Scrubber::PressInPrompt(const std::string& key) {
  if (key == "enter") {
    Answer();
  } else if (key == "backspace") {
    if (!typed_.empty()) typed_.pop_back();
    return true;
  } else if (key == "escape") {
    message_.clear();
  } else {
    if (key.size() == 1) typed_ += key;
    return true;
  }
  prompt_.clear();
  typed_.clear();
  return true;
}

void Scrubber::Answer() {
  if (prompt_ == "search") return Search(typed_);
  char* end = nullptr;
  const double number = std::strtod(typed_.c_str(), &end);
  if (typed_.empty() || *end != '\0' || !(number >= 0 && number < 1e9)) {
    message_ = "\"" + typed_ + "\" is no number";
  } else if (prompt_ == "tick") {
    GoTo(run_.Find(static_cast<std::uint64_t>(number)));
  } else {
    GoTo(run_.FindTime(run_.start() + Duration(static_cast<std::int64_t>(number * 1e9))));
  }
}

void Scrubber::Move(std::int64_t entries) {
  const auto last = static_cast<std::int64_t>(run_.ticks().size()) - 1;
  const std::int64_t to = static_cast<std::int64_t>(entry_) + entries;
  GoTo(static_cast<std::size_t>(std::clamp<std::int64_t>(to, 0, last)));
}

void Scrubber::GoTo(std::size_t entry) {
  entry_ = std::min(entry, run_.ticks().size() - 1);
  node_ = std::min(node_, static_cast<NodeIndex>(tree().nodes.size() - 1));
}

// Whether the node did something else in this entry than in the one before.
bool Scrubber::Differs(std::size_t entry) const {
  const auto results = [&](std::size_t i) {
    std::vector<Status> found;
    EventReader reader(run_.EventsOf(i).words);
    for (Event event; reader.Next(event);) {
      if (event.is_status() && event.index == node_) found.push_back(event.status());
    }
    return found;
  };
  return run_.TreeOf(entry) == run_.TreeOf(entry - 1) && results(entry) != results(entry - 1);
}

void Scrubber::GoToChange(int direction) {
  std::size_t at = entry_;
  while (direction > 0 ? at + 1 < run_.ticks().size() : at > 1) {
    at = direction > 0 ? at + 1 : at - 1;
    if (Differs(at)) return GoTo(at);
  }
  message_ = "no change of this node " + std::string(direction > 0 ? "behind" : "before") + " this";
}

void Scrubber::Search(const std::string& text) {
  if (!text.empty()) searched_ = text;
  const auto nodes = static_cast<NodeIndex>(tree().nodes.size());
  for (NodeIndex step{1}; step <= nodes; ++step) {
    const NodeIndex node((node_ + step) % nodes);
    if (tree().nodes[node].path.find(searched_) == std::string::npos) continue;
    node_ = node;
    return;
  }
  message_ = "no node with \"" + searched_ + "\" in its path";
}

void Scrubber::Explain() {
  Diagnostics diagnostics;
  const RecordedTree recorded = CompileRecorded(tree(), std::make_shared<Registry>(), diagnostics);
  const TickView now = run_.Before(entry_);
  std::optional<TickView> before;
  if (const auto earlier = run_.TickBefore(entry_)) before = run_.Before(*earlier);
  message_ =
      PrintWhy(recorded, WhyOf(recorded, now, before ? &*before : nullptr, node_), run_.start());
}

std::string Scrubber::Render(std::size_t lines, std::size_t columns) const {
  const TreePicture picture = PictureOf(run_, entry_);
  const std::string title =
      "tick " + std::to_string(picture.tick) + " of " + std::to_string(run_.ticks().back().number) +
      "   " + JsonSeconds(picture.time - run_.start()) + " s   " + ToString(picture.result);
  std::vector<std::string> below = LinesOf(message_);
  if (!prompt_.empty()) below = {prompt_ + ": " + typed_};
  const std::size_t room = lines > 3 ? lines - 2 : 1;
  if (below.size() > room / 2) below.resize(room / 2);
  const std::size_t shown = room - below.size();
  const std::size_t first = node_ < shown / 2 ? 0 : node_ - shown / 2;
  std::string text = Cut(title, columns) + "\n";
  for (std::size_t i = first; i < first + shown && i < tree().nodes.size(); ++i) {
    const auto node = static_cast<NodeIndex>(i);
    text += (node == node_ ? "> " : "  ") +
            Cut(NodeLine(tree(), picture, node, true), columns > 2 ? columns - 2 : 1) + "\n";
  }
  for (const std::string& line : below) text += Cut(line, columns) + "\n";
  return text + Cut(kHelp, columns);
}

}  // namespace coppice
