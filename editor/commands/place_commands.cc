#include "editor/commands/place_commands.h"

#include <string>
#include <utility>

#include "editor/commands/run_commands.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

class PlaceCommands {
 public:
  explicit PlaceCommands(EditorState& state) : state_(state) {}

  void AddAll() {
    Add("run.bookmark", "Set or remove a bookmark at the shown tick", {'M'},
        [this_ = *this](RunView& run) { this_.ToggleBookmark(run); });
    Add("run.bookmark_text", "Text of the bookmark", {'M', kShift},
        [this_ = *this](RunView& run) { this_.AskForWords(run); });
    Add("run.bookmark_before", "To the previous bookmark", {kKeyLeft, kCtrl | kAlt},
        [this_ = *this](RunView& run) { this_.GoToBookmark(run, false); });
    Add("run.next_bookmark", "To the next bookmark", {kKeyRight, kCtrl | kAlt},
        [this_ = *this](RunView& run) { this_.GoToBookmark(run, true); });
    Add("run.bookmarks", "Bookmarks of the run", {'M', kCtrl},
        [this_ = *this](RunView& run) { this_.OfferBookmarks(run); });
    Add("run.to_here", "Run to here: until the node is ticked", {kKeyF1 + 9, kCtrl},
        [this_ = *this](RunView& run) { this_.RunToHere(run); });
  }

 private:
  void Add(std::string id, std::string title, KeyChord keys, std::function<void(RunView&)> run) {
    EditorCommand command{std::move(id), std::move(title), keys, {}, {}};
    command.run = [&s = state_, run = std::move(run)] {
      if (RunView* view = s.workspace.run()) run(*view);
    };
    command.when = [&s = state_] { return s.workspace.run() != nullptr; };
    state_.commands.Add(std::move(command));
  }

  Bookmarks& bookmarks() const { return state_.workspace.bookmarks; }

  void ToggleBookmark(RunView& run) const {
    if (run.run().size() == 0) return;
    const std::size_t tick = run.playhead().tick();
    const std::string name = run.bookmark_name();
    if (bookmarks().Of(name).count(tick) > 0) return bookmarks().Remove(name, tick);
    bookmarks().Set(name, tick, "");
    state_.Notify("Bookmark; Shift+M gives it a text", state_.now);
  }

  void AskForWords(RunView& run) const {
    if (run.run().size() == 0) return;
    const std::size_t tick = run.playhead().tick();
    const std::string name = run.bookmark_name();
    const Bookmarks::OfRun& there = bookmarks().Of(name);
    const auto known = there.find(tick);
    state_.Ask({"Bookmark: what there is to see here",
                [&s = state_, name, tick](const std::string& text) {
                  s.workspace.bookmarks.Set(name, tick, text);
                  return Outcome();
                },
                {}},
               known == there.end() ? "" : known->second);
  }

  void GoToBookmark(RunView& run, bool forward) const {
    const std::string name = run.bookmark_name();
    const std::size_t tick = run.playhead().tick();
    const auto* mark = forward ? bookmarks().Next(name, tick) : bookmarks().Before(name, tick);
    if (!mark) {
      return state_.Notify(forward ? "no bookmark after this tick" : "no bookmark before this tick",
                           state_.now, true);
    }
    run.playhead().GoToTick(mark->first);
    if (!mark->second.empty()) state_.Notify(mark->second, state_.now);
  }

  void OfferBookmarks(RunView& run) const {
    std::vector<Choice> rows;
    for (const auto& [tick, text] : bookmarks().Of(run.bookmark_name())) {
      Choice row;
      row.title = text.empty() ? "tick " + std::to_string(tick) : text;
      row.kind = "bookmark";
      row.note = std::to_string(tick);
      row.run = [&s = state_, tick = tick] {
        if (RunView* shown = s.workspace.run()) shown->playhead().GoToTick(tick);
      };
      rows.push_back(std::move(row));
    }
    if (rows.empty()) return state_.Notify("no bookmarks: M sets one", state_.now, true);
    state_.Offer({"Go to a bookmark", [rows](const std::string& typed) {
                    std::vector<Choice> fitting;
                    for (const Choice& row : rows) {
                      if (row.title.find(typed) != std::string::npos) fitting.push_back(row);
                    }
                    return fitting;
                  }});
  }

  void RunToHere(RunView& run) const {
    const std::string path = SelectedRunPath(state_);
    if (path.empty()) return state_.Notify("Select a node first", state_.now, true);
    if (run.source().is_simulation()) return SimulationEditor(state_, state_.now).TickUntilTicked();
    if (!run.source().is_robot()) {
      state_.commands.Run("run.next_change");
      return;
    }
    Hook stop;
    stop.path = path;
    stop.times = 1;
    state_.workspace.hooks.Add(run.name(), stop);
    run.Update(state_.workspace.hooks, state_.now);  // it is set before the robot goes on
    run.playhead().GoToNow();
    if (run.stop().where != DebugStop::Where::kNowhere) {
      run.Send(MakeCommand(LiveCommand::Kind::kContinue));
    }
  }

  EditorState& state_;
};

}  // namespace

void AddPlaceCommands(EditorState& state) { PlaceCommands(state).AddAll(); }

}  // namespace coppice::editor
