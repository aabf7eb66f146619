#include "editor/panels/start_screen.h"

#include <algorithm>
#include <string>

#include "editor/panels/widgets/panel.h"
#include "editor/workspace/file_keeper.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 360;  // pixels at scale 1
constexpr float kButton = 30;
constexpr float kGap = 8;
constexpr std::size_t kRecent = 6;
constexpr std::size_t kRobots = 4;

struct StartOffer {
  const char* path;
  const char* title;
  const char* command;
};

// What shows what the editor is for.
constexpr StartOffer kExamples[] = {{"start/tour", "Two-minute tour", "help.tour"},
                                    {"start/example_tree", "A tree", "example.tree"},
                                    {"start/example_record", "A record of a run", "example.record"},
                                    {"start/example_robot", "A simulated robot", "example.robot"}};

constexpr StartOffer kOffers[] = {{"start/open", "Open a file", "file.open"},
                                  {"start/new", "New file", "file.new"},
                                  {"start/connect", "Connect to a robot", "robot.connect"}};

// A headline, and a sentence on what can be done about it.
struct Words {
  std::string headline;
  std::string advice;
};

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

Words WordsOfFile(const OpenFile& file) {
  for (const Diagnostic& problem : file.problems) {
    if (problem.severity != Severity::kError) continue;
    const std::string line =
        problem.where.line > 0 ? " on line " + std::to_string(problem.where.line) : "";
    return {NameOf(file.path) + " has an error" + line,
            problem.message +
                ". Correct it in the XML tile; the tree is shown as soon as the text "
                "can be read."};
  }
  return {NameOf(file.path) + " contains no tree", "Ctrl+T makes one."};
}

Words WordsOf(const EditorState& state) {
  const Workspace& workspace = state.workspace;
  if (const RunView* run = workspace.run()) {
    if (!run->source().is_robot()) return {"Reading " + NameOf(run->name()), ""};
    const std::string& problem = run->connection().problem;
    return {"Waiting for " + run->name(), problem.empty()
                                              ? "Its tree will be shown as soon as it answers."
                                              : problem + ". Coppice keeps trying."};
  }
  if (workspace.ShownTree()) {
    return {"\"" + workspace.ShownTreeId() + "\" is empty",
            "Tab adds its root node; you can also drag a type here from the NODES tile."};
  }
  return WordsOfFile(*workspace.file());
}

class StartScreen {
 public:
  StartScreen(const Ui& ui, EditorState& state, const Box& canvas)
      : ui_(ui),
        state_(state),
        list_(*ImGui::GetWindowDrawList()),
        width_(std::min(kWidth * ui.scale, canvas.width() - 2 * kGap * ui.scale)),
        left_(canvas.center().x - width_ / 2),
        y_(canvas.min.y + canvas.height() * 0.2F) {}

  void Say(const Words& words) {
    Centered(words.headline, {Face::kBold, 15, ui_.palette.text});
    Centered(words.advice, {Face::kSans, 12, ui_.palette.text_dim});
  }

  void Offer() {
    Centered("Coppice", {Face::kBold, 22, ui_.palette.text});
    Centered("Behaviour trees: write them, watch them, try them out",
             {Face::kSans, 12, ui_.palette.text_dim});
    y_ += kGap * ui_.scale;
    for (const auto& offer : kOffers) OfferCommand(offer);
    OfferUnsaved();
    OfferExamples();
    OfferRobots();
    OfferRecent();
  }

 private:
  // Broken into lines, each in the middle.
  void Centered(const std::string& text, const TextStyle& style) {
    const ImFont* font = ui_.fonts.For(text, style.face, style.size * ui_.scale);
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
      const char* stop = font->CalcWordWrapPositionA(1, at, end, width_);
      if (stop == at) ++stop;
      const std::string line(at, stop);
      ui_.Text(list_, {left_ + (width_ - ui_.Width(line, style)) / 2, y_}, line, style);
      y_ += font->FontSize * 1.3F;
      at = stop;
      while (at < end && *at == ' ') ++at;
    }
    y_ += kGap * ui_.scale;
  }

  Box Take(float height) {
    const Box box = {{left_, y_}, {left_ + width_, y_ + height * ui_.scale}};
    y_ = box.max.y + kGap * ui_.scale;
    return box;
  }

  void OfferCommand(const StartOffer& offer) {
    const Box box = Take(kButton);
    const bool pressed = ui_.Button(offer.path, box, "");
    const float pad = 12 * ui_.scale;
    ui_.RowText(list_, box.min + Point{pad, 0}, box.height(), offer.title,
                {Face::kSans, 13, ui_.palette.text});
    if (const EditorCommand* command = state_.commands.Find(offer.command)) {
      const std::string keys = ToString(command->keys);
      const TextStyle dim{Face::kSans, 12, ui_.palette.text_dim};
      ui_.RowText(list_, {box.max.x - pad - ui_.Width(keys, dim), box.min.y}, box.height(), keys,
                  dim);
    }
    if (pressed) state_.after_frame = [&s = state_, id = offer.command] { s.commands.Run(id); };
  }

  void OfferExamples() {
    Heading("try it", ui_.palette.text_dim);
    for (const StartOffer& offer : kExamples) {
      const Box box = Take(20);
      y_ -= kGap * ui_.scale;
      bool hovered = false;
      const bool pressed = ui_.Hit(offer.path, box, &hovered);
      ui_.RowText(list_, box.min, box.height(), offer.title,
                  {Face::kSans, 12, hovered ? ui_.palette.accent : ui_.palette.link});
      if (pressed) state_.after_frame = [&s = state_, id = offer.command] { s.commands.Run(id); };
    }
  }

  void Heading(const char* text, Color color) {
    y_ += kGap * ui_.scale;
    ui_.RowText(list_, {left_, y_}, 20 * ui_.scale, text, {Face::kBold, 11, color});
    y_ += 22 * ui_.scale;
  }

  void OfferUnsaved() {
    const std::vector<UnsavedCopy> left = state_.work.left();  // a click takes one out
    if (left.empty()) return;
    Heading("unsaved work of earlier sessions", ui_.palette.warning);
    for (std::size_t i = 0; i < std::min(left.size(), kRecent); ++i) OfferCopy(left[i], i);
  }

  void OfferCopy(const UnsavedCopy& copy, std::size_t number) {
    const Choice made =
        OfferForgettable("start/unsaved/" + std::to_string(number), copy.path, AgeOf(copy));
    if (made == Choice::kForget) state_.after_frame = [&s = state_, copy] { s.work.Forget(copy); };
    if (made == Choice::kTake) {
      state_.after_frame = [&s = state_, copy] { FileKeeper(s, s.now).Restore(copy); };
    }
  }

  void OfferRobots() {
    const std::vector<OfferedRobot> robots = state_.OfferedRobots();
    std::size_t known = 0;
    std::size_t found = 0;
    for (const OfferedRobot& robot : robots) {
      std::size_t& count = robot.is_known ? known : found;
      if (count == kRobots) continue;
      if (!robot.is_known && found == 0) Heading("robots on the network", ui_.palette.text_dim);
      if (robot.is_known && known == 0) Heading("robots", ui_.palette.text_dim);
      OfferRobot(robot, (robot.is_known ? "start/robot/" : "start/found/") + std::to_string(count));
      ++count;
    }
  }

  void OfferRobot(const OfferedRobot& robot, const std::string& path) {
    const Choice made = robot.is_known ? OfferForgettable(path, robot.endpoint, robot.note)
                                       : OfferNoted(path, Take(20), robot.endpoint, robot.note);
    if (!robot.is_known) y_ -= kGap * ui_.scale;
    if (made == Choice::kNone) return;
    state_.after_frame = [&s = state_, made, endpoint = robot.endpoint] {
      if (made == Choice::kForget) return ForgetRobot(s.recent.robots, endpoint);
      s.Connect(endpoint);
    };
  }

  enum class Choice { kNone, kTake, kForget };

  // A row that is taken with a click, or forgotten with one on its end.
  Choice OfferForgettable(const std::string& path, const std::string& title,
                          const std::string& note) {
    Box box = Take(20);
    y_ -= kGap * ui_.scale;
    const TextStyle dim{Face::kSans, 11, ui_.palette.text_dim};
    const float width = ui_.Width("forget", dim) + 8 * ui_.scale;
    const Box forget = {{box.max.x - width, box.min.y}, box.max};
    box.max.x = forget.min.x;
    bool hovered = false;
    const bool forgotten = ui_.Hit(path + "/forget", forget, &hovered);
    ui_.RowText(list_, forget.min + Point{8 * ui_.scale, 0}, forget.height(), "forget",
                {Face::kSans, 11, hovered ? ui_.palette.error : ui_.palette.text_dim});
    const Choice made = OfferNoted(path, box, title, note);
    return forgotten ? Choice::kForget : made;
  }

  // A row that is taken with a click.
  Choice OfferNoted(const std::string& path, const Box& box, const std::string& title,
                    const std::string& note) {
    const TextStyle dim{Face::kSans, 11, ui_.palette.text_dim};
    const float wished = ui_.Width(note, dim) + 8 * ui_.scale;
    const float note_width = std::min(wished, box.width() * 0.6F);
    bool hovered = false;
    const bool pressed = ui_.Hit(path, box, &hovered);
    const TextStyle style{Face::kSans, 12, hovered ? ui_.palette.accent : ui_.palette.link};
    ui_.RowText(list_, box.min, box.height(), ui_.CutStart(title, style, box.width() - note_width),
                style);
    ui_.RowText(list_, {box.max.x - note_width + 8 * ui_.scale, box.min.y}, box.height(), note, dim,
                note_width - 8 * ui_.scale);
    return pressed ? Choice::kTake : Choice::kNone;
  }

  void OfferRecent() {
    if (state_.recent.files.empty()) return;
    Heading("recent files", ui_.palette.text_dim);
    for (std::size_t i = 0; i < std::min(state_.recent.files.size(), kRecent); ++i) {
      const std::string path = state_.recent.files[i];
      const bool is_there = state_.paths.IsThere(path, ui_.now);
      const Box box = Take(20);
      y_ -= kGap * ui_.scale;
      bool hovered = false;
      const bool pressed = ui_.Hit("start/recent/" + std::to_string(i), box, &hovered);
      const TextStyle style{Face::kSans, 12,
                            !is_there ? ui_.palette.text_dim
                            : hovered ? ui_.palette.accent
                                      : ui_.palette.link};
      ui_.RowText(list_, box.min, box.height(), ui_.CutStart(path, style, width_), style);
      if (hovered && !is_there) Tooltip(ui_, "this file no longer exists");
      if (pressed && is_there)
        state_.after_frame = [&s = state_, path] { s.services.open_file(path); };
    }
  }

  const Ui& ui_;
  EditorState& state_;
  ImDrawList& list_;
  const float width_;
  const float left_;
  float y_;
};

}  // namespace

void DrawStartScreen(const Ui& ui, EditorState& state, const Box& canvas) {
  ui.Fill(*ImGui::GetWindowDrawList(), canvas, ui.palette.canvas);
  StartScreen screen(ui, state, canvas);
  const bool is_start = !state.workspace.run() && !state.workspace.file();
  if (is_start) {
    screen.Offer();
  } else {
    screen.Say(WordsOf(state));
  }
}

}  // namespace coppice::editor
