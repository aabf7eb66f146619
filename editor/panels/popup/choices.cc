#include "editor/panels/popup/choices.h"

#include <algorithm>
#include <utility>

#include "editor/keys/fuzzy.h"
#include "editor/keys/recent.h"

namespace coppice::editor {
namespace {

class Collector {
 public:
  Collector(const std::string& typed, EditorState& state) : typed_(typed), state_(state) {}

  void Offer(std::string title, std::string note, std::string kind, std::function<void()> run) {
    const int fit = FuzzyScore(typed_, title);
    if (fit == 0) return;
    const std::string used = kind + " " + title;
    const int score = fit + BonusOf(state_.recent.choices, used);
    choices_.push_back({std::move(title), std::move(note), std::move(kind), score,
                        [&s = state_, used, run = std::move(run)] {
                          UseAgain(s.recent.choices, used);
                          run();
                        }});
  }

  std::vector<Choice> Best(std::size_t limit) {
    std::stable_sort(choices_.begin(), choices_.end(),
                     [](const Choice& a, const Choice& b) { return a.score > b.score; });
    if (choices_.size() > limit) choices_.resize(limit);
    return std::move(choices_);
  }

 private:
  const std::string& typed_;
  EditorState& state_;
  std::vector<Choice> choices_;
};

void OfferNodes(EditorState& state, Collector& collector) {
  TreeView* view = state.workspace.view();
  if (!view) return;
  const auto& nodes = view->scene()->nodes;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    collector.Offer(std::string(nodes[i].name), std::string(nodes[i].id) + "  " + nodes[i].path,
                    "node", [&state, i] {
                      TreeView* shown = state.workspace.view();
                      if (!shown || i >= shown->scene()->nodes.size()) return;
                      shown->Select(i);
                      shown->RevealReadable(state.screen.canvas_size);
                    });
  }
}

void OfferTrees(EditorState& state, Collector& collector, double now) {
  Workspace& workspace = state.workspace;
  for (std::size_t f = 0; f < workspace.files().size(); ++f) {
    const Forest& forest = *workspace.files()[f].forest;
    for (std::size_t t = 0; t < forest.trees().size(); ++t) {
      collector.Offer(
          forest.trees()[t].id, workspace.files()[f].path, "tree",
          [&workspace, f, t, now] { workspace.ShowFileTree(f, static_cast<int>(t), now); });
    }
  }
}

}  // namespace

std::vector<Choice> FindChoices(EditorState& state, const std::string& typed, double now,
                                std::size_t limit) {
  Collector collector(typed, state);
  for (const EditorCommand& command : state.commands.all()) {
    collector.Offer(command.title, ToString(command.keys), "command", command.run);
  }
  if (!typed.empty()) OfferNodes(state, collector);
  OfferTrees(state, collector, now);
  Workspace& workspace = state.workspace;
  for (std::size_t i = 0; i < workspace.runs().size(); ++i) {
    const RunSource& source = workspace.runs()[i]->source();
    collector.Offer(source.name(), "", source.is_robot() ? "robot" : "record",
                    [&workspace, i] { workspace.ShowRun(i); });
  }
  return collector.Best(limit);
}

}  // namespace coppice::editor
