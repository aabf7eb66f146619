#include "bt_core/cli/live/live_screen.h"

#include <algorithm>
#include <cstdio>

#include "bt_core/base/plain.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

constexpr char kBold[] = "\x1b[1m";
constexpr char kDim[] = "\x1b[2m";
constexpr char kPlain[] = "\x1b[0m";

const char* ColourOf(Status status) {
  switch (status) {
    case Status::kRunning:
      return "\x1b[33m";
    case Status::kSuccess:
      return "\x1b[32m";
    case Status::kFailure:
      return "\x1b[31m";
    default:
      return kDim;
  }
}

std::string Seconds(Duration time) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.3f s", std::chrono::duration<double>(time).count());
  return text;
}

// What the robot says must not move the cursor; characters that are cut stay whole.
std::string Clean(const std::string& said, std::size_t columns) {
  std::string text = PlainLine(said);
  if (columns == 0) return text;
  std::size_t size = 0;
  std::size_t characters = 0;
  const auto begins = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xc0) != 0x80;
  };
  while (size < text.size() && (!begins(size) || characters < columns)) {
    characters += begins(size);
    ++size;
  }
  return text.substr(0, size);
}

std::string Describe(const ForeignHook& foreign) {
  return "somebody else's hook at " + foreign.hook.path + ": " + ToString(foreign.hook) +
         (foreign.hook.enabled ? "" : " (off)");
}

class Screen {
 public:
  Screen(const LiveScene& scene, const ScreenOptions& options) : scene_(scene), options_(options) {}

  std::vector<std::string> Draw() {
    Add(Title(), kBold);
    if (!scene_.connection.problem.empty()) Add(scene_.connection.problem, "\x1b[31m");
    if (!scene_.stop.empty()) Add(scene_.stop, "\x1b[35m");
    for (const ForeignHook& foreign : scene_.foreign_hooks) Add(Describe(foreign), "\x1b[35m");
    if (scene_.run.state()) {
      AddNodes(scene_.texts.size() + (options_.shows_board ? BoardSize() + 1 : 0));
      if (options_.shows_board) AddBoard();
      for (const std::string& text : scene_.texts) Add("  " + text, kDim);
    }
    if (options_.rows > 0 && lines_.size() > options_.rows) lines_.resize(options_.rows);
    return std::move(lines_);
  }

 private:
  void Add(const std::string& text, const char* look = "") {
    const std::string line = Clean(text, options_.columns);
    const bool is_plain = !options_.has_colours || *look == '\0';
    lines_.push_back(is_plain ? line : look + line + kPlain);
  }

  std::string Title() const {
    std::string title = options_.endpoint;
    if (!scene_.run.state()) return title;
    title += "  " + scene_.run.tree().main_tree + "  tick " +
             std::to_string(scene_.run.state()->tick()) + "  " + ToString(scene_.result) + "  " +
             Seconds(scene_.run.state()->time().time_since_epoch());
    if (scene_.duration > Duration::zero()) {
      title += "  " + std::to_string(scene_.duration / std::chrono::microseconds(1)) + " us";
    }
    if (scene_.connection.protocol == LiveConnection::Protocol::kGroot2) title += "  (Groot2)";
    if (scene_.lost_ticks > 0) title += "  " + std::to_string(scene_.lost_ticks) + " ticks lost";
    return title;
  }

  std::size_t BoardSize() const {
    return static_cast<std::size_t>(
        std::count_if(scene_.run.tree().slots.begin(), scene_.run.tree().slots.end(),
                      [](const DescribedSlot& s) { return s.has_key; }));
  }

  // `reserved` rows are left for what comes below.
  void AddNodes(std::size_t reserved) {
    const std::size_t count = scene_.run.tree().nodes.size();
    const std::size_t used = lines_.size() + reserved;
    const std::size_t room =
        options_.rows == 0 ? count : std::max<std::size_t>(options_.rows, used + 5) - used;
    const bool is_crowded = count > room;
    std::size_t left_out = 0;
    std::size_t drawn = 0;
    for (NodeIndex i{0}; i < count; ++i) {
      if (is_crowded && (!IsNear(i) || drawn + 1 >= room)) {
        ++left_out;
        continue;
      }
      AddNode(i);
      ++drawn;
    }
    if (left_out > 0) Add("  ... and " + std::to_string(left_out) + " more nodes", kDim);
  }

  bool IsNear(NodeIndex node) const {
    const NodeIndex parent = scene_.run.tree().nodes[node].parent;
    return Of(node) != Status::kIdle || Of(parent) == Status::kRunning;
  }
  Status Of(NodeIndex node) const { return scene_.run.state()->status(node); }

  void AddNode(NodeIndex node) {
    const DescribedNode& described = scene_.run.tree().nodes[node];
    const Status status = Of(node);
    const Status last = scene_.run.state()->last(node);
    std::string line = status == Status::kRunning ? "> " : "  ";
    line.append(2 * Depth(node), ' ');
    line += OwnName(described);
    if (status != Status::kIdle) {
      line += "  " + std::string(ToString(status));
    } else if (last != Status::kIdle) {
      line += "  (" + std::string(ToString(last)) + ")";
    }
    const std::string look =
        std::string(status == Status::kRunning ? kBold : "") + ColourOf(status);
    Add(line, look.c_str());
  }

  std::size_t Depth(NodeIndex node) const {
    std::size_t depth = 0;
    for (; scene_.run.tree().nodes[node].parent != node;
         node = scene_.run.tree().nodes[node].parent)
      ++depth;
    return depth;
  }

  // The last part of the path, and the type if that is another word.
  static std::string OwnName(const DescribedNode& node) {
    const std::string own = node.path.substr(node.path.rfind('/') + 1);
    const bool has_type = own.compare(0, node.id.size(), node.id) == 0;
    return has_type ? own : own + " [" + node.id + "]";
  }

  void AddBoard() {
    Add("");
    for (SlotIndex slot{0}; slot < scene_.run.tree().slots.size(); ++slot) {
      const DescribedSlot& described = scene_.run.tree().slots[slot];
      if (!described.has_key) continue;
      const std::string& bytes = scene_.run.state()->values()[slot];
      const bool is_empty = FormOfValue(bytes) == ValueForm::kEmpty;
      Add("  " + described.scope + "/" + described.name + " = " +
              (is_empty ? "(no value)" : PrintValueBytes(bytes)),
          is_empty ? kDim : "");
    }
  }

  const LiveScene& scene_;
  const ScreenOptions& options_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> DrawScene(const LiveScene& scene, const ScreenOptions& options) {
  return Screen(scene, options).Draw();
}

}  // namespace coppice
