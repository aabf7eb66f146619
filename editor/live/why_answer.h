// Why a node is as it is at the tick that is shown, as lines: the walk of the tick on the way to
// it. Worked out again only when the question is another one.
#ifndef COPPICE_EDITOR_LIVE_WHY_ANSWER_H_
#define COPPICE_EDITOR_LIVE_WHY_ANSWER_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "editor/live/run_view.h"

namespace coppice::editor {

struct WhyLine {
  NodeIndex node{0};
  std::uint32_t depth = 0;
  Status status = Status::kIdle;
  std::string name;
  std::string reason;  ///< "because DoorOpen is FAILURE", "battery = 12"
  bool is_asked = false;
  bool is_news = false;  ///< it ended otherwise in the tick before
};

class WhyAnswer {
 public:
  /// The run must have a tick and a tree.
  void Ask(const RunView& view, NodeIndex node);

  const std::vector<WhyLine>& lines() const { return lines_; }
  /// What kept the node from being ticked, or why that is not known; empty if it was.
  const std::string& why_not() const { return why_not_; }
  /// Whether it was ticked is not told.
  bool is_untold() const { return is_untold_; }
  /// The first thing that went another way than in the tick before, and at which node; empty:
  /// nothing did.
  const std::string& change() const { return change_; }
  NodeIndex changed_node() const { return changed_node_; }
  /// Where the robot stands in this tick, behind all lines: stands before "Drive"; empty: nowhere.
  const std::string& stands() const { return stands_; }
  NodeIndex stands_at() const { return asked_.stop_at; }

 private:
  struct Question {
    const RunView* view = nullptr;
    const RunTree* tree = nullptr;
    std::size_t tick = 0;
    std::size_t words = 0;  // of the tick, which may still go on
    NodeIndex node{0};
    DebugStop::Where stop = DebugStop::Where::kNowhere;
    NodeIndex stop_at = kNoNode;
  };

  Question asked_;
  std::vector<WhyLine> lines_;
  std::string why_not_;
  bool is_untold_ = false;
  std::string change_;
  std::string stands_;
  NodeIndex changed_node_{0};
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_WHY_ANSWER_H_
