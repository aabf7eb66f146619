#include "bt_core/analysis/formats/btlog.h"
#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/formats/full_xml.h"
#include "bt_core/analysis/why/run_walk.h"

namespace coppice {
namespace {

constexpr std::size_t kMaxNodes = UINT16_MAX;

class Collector final : public RunVisitor {
 public:
  /// Transitions of this tree only.
  Collector(const TreeDescription& tree, std::vector<BtlogTransition>& transitions)
      : tree_(tree), transitions_(transitions) {}

  void OnSection(const TreeDescription& tree, const Recording::Section&) override {
    is_wanted_ = &tree == &tree_;
  }
  void OnChange(const StatusChange& change, const TickEvents& events) override {
    if (!is_wanted_) return;
    const Duration since_1970 = tree_.info.WallAt(events.start).time_since_epoch();
    transitions_.push_back(
        {since_1970.count() / 1000, static_cast<std::uint16_t>(change.node + 1), change.to});
  }

 private:
  const TreeDescription& tree_;
  std::vector<BtlogTransition>& transitions_;
  bool is_wanted_ = false;
};

}  // namespace

std::optional<std::string> ToBtlog(const Recording& run, Diagnostics& diagnostics) {
  const TreeDescription& tree = run.trees().front();
  if (tree.nodes.size() > kMaxNodes) {
    diagnostics.Error({}, "the tree has " + std::to_string(tree.nodes.size()) +
                              " nodes; a .btlog has 16 bits for their numbers, so at most 65535");
    return std::nullopt;
  }
  if (run.trees().size() > 1) {
    diagnostics.Warning({}, "a .btlog has one tree: what happened after the swap is left out");
  }
  Btlog log;
  log.xml = FullXml(tree);
  Collector collector(tree, log.transitions);
  WalkRun(run, collector);
  return WriteBtlog(log);
}

}  // namespace coppice
