#include "robot_app/tablet/tablet_desk.h"

#include <chrono>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "bt_core/base/hex.h"
#include "bt_core/base/json_library.h"
#include "robot_app/knowledge/answers/real_way.h"

namespace coppice::robot::tablet {
namespace {

using knowledge::Answer;
using knowledge::Request;
using knowledge::TouchButton;
using knowledge::TouchScreen;

constexpr std::size_t kLongestPath = 8;      // steps
constexpr std::size_t kLongestText = 300;    // bytes
constexpr std::chrono::seconds kHeldFor{3};  // a page says it each half second
constexpr char kRefused[] = "That cannot be asked here.";

// Throws if it is too long.
std::string TextOf(const nlohmann::json& call, const char* name) {
  std::string text = call.at(name).get<std::string>();
  if (text.size() > kLongestText) throw std::length_error("too long");
  return text;
}

// What others say of themselves, on topics, may be no text at all.
std::string TextOf(const nlohmann::json& reply) {
  return reply.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<std::string> PathOf(const nlohmann::json& call) {
  auto path = call.at("path").get<std::vector<std::string>>();
  if (path.size() > kLongestPath) throw std::length_error("too long");
  return path;
}

}  // namespace

const TabletDesk::Deed TabletDesk::kDeeds[] = {
    {"screen", &TabletDesk::Screen},   {"press", &TabletDesk::Press},
    {"ask", &TabletDesk::Ask},         {"choose", &TabletDesk::Choose},
    {"guide", &TabletDesk::Guide},     {"stop", &TabletDesk::Stop},
    {"talk", &TabletDesk::Talk},       {"leave", &TabletDesk::Leave},
    {"touched", &TabletDesk::Touched}, {"map", &TabletDesk::Map},
    {"state", &TabletDesk::State}};

TabletDesk::TabletDesk(std::unique_ptr<knowledge::Dialogue> dialogue, TopologicalMap map,
                       TabletLinks& links, std::function<WallTime()> clock)
    : dialogue_(std::move(dialogue)),
      home_language_(LanguageCode()),
      guide_(std::move(map)),
      links_(links),
      clock_(std::move(clock)) {
  dialogue_->set_way(
      [this] { return view_.pose ? knowledge::RealWay(guide_, *view_.pose) : knowledge::WayTo(); });
}

std::string TabletDesk::Reply(const std::string& call) {
  const std::lock_guard lock(mutex_);
  was_asked_ = true;
  try {
    const Json json = ParseLimitedJson(call);
    const std::string what = json.at("do").get<std::string>();
    const auto language = knowledge::LanguageOf(json.value("language", LanguageCode()));
    if (language) dialogue_->set_language(*language);
    for (const Deed& deed : kDeeds) {
      if (what == deed.name) return TextOf((this->*deed.handler)(json));
    }
  } catch (const std::exception&) {  // whatever it was, the page learns nothing from it
  }
  return Json{{"error", kRefused}}.dump();
}

void TabletDesk::SetGrid(OccupancyGrid grid) {
  const std::lock_guard lock(mutex_);
  grid_ = std::move(grid);
}

void TabletDesk::ChangeView(const std::function<void(TabletView& view)>& change) {
  const std::lock_guard lock(mutex_);
  change(view_);
}

bool TabletDesk::TakeWasAsked() {
  const std::lock_guard lock(mutex_);
  return std::exchange(was_asked_, false);
}

void TabletDesk::EndTalkUnlessHeld() {
  const std::lock_guard lock(mutex_);
  if (!held_at_) return;
  const auto since = clock_() - *held_at_;
  if (since <= kHeldFor && since >= -kHeldFor) return;
  held_at_.reset();
  links_.Talk(false);
}

nlohmann::json TabletDesk::Screen(const Json& call) {
  const TouchScreen screen = dialogue_->Screen(PathOf(call));
  Json buttons = Json::array();
  for (const TouchButton& button : screen.buttons) {
    buttons.push_back({{"step", button.step}, {"label", button.label}});
  }
  return {{"buttons", buttons}, {"answers", screen.request.has_value()}};
}

nlohmann::json TabletDesk::Press(const Json& call) {
  const TouchScreen screen = dialogue_->Screen(PathOf(call));
  if (!screen.request) throw std::invalid_argument("means nothing");
  return Told(dialogue_->Press(*screen.request, clock_()));
}

nlohmann::json TabletDesk::Ask(const Json& call) {
  return Told(dialogue_->Hear(TextOf(call, "text"), clock_()));
}

nlohmann::json TabletDesk::Choose(const Json& call) {
  const Request chosen = choices_.at(call.at("number").get<std::size_t>()).request;
  return Told(dialogue_->Press(chosen, clock_()));
}

// The choices are kept: the page tells which one was pressed.
nlohmann::json TabletDesk::ToJson(const Answer& answer) {
  choices_ = answer.choices;
  Json labels = Json::array();
  for (const knowledge::Choice& choice : choices_) labels.push_back(choice.label);
  return {{"text", answer.text},
          {"mood", knowledge::Word(answer.mood)},
          {"choices", labels},
          {"place", answer.place},
          {"way", WayTo(answer.place)}};
}

nlohmann::json TabletDesk::Told(const Answer& answer) {
  links_.Answered(answer, LanguageCode());
  return ToJson(answer);
}

nlohmann::json TabletDesk::Guide(const Json& call) {
  Answer answer;
  answer.place = TextOf(call, "place");
  answer.guides = true;
  if (guide_.map().Find(answer.place) < 0) throw std::invalid_argument("no such place");
  view_.outcome.clear();
  links_.Answered(answer, LanguageCode());
  return Json::object();
}

nlohmann::json TabletDesk::Stop(const Json&) {
  links_.StopGuiding();
  return Json::object();
}

nlohmann::json TabletDesk::Talk(const Json& call) {
  const bool on = call.at("on").get<bool>();
  held_at_ = on ? std::optional(clock_()) : std::nullopt;
  links_.Talk(on);
  return Json::object();
}

nlohmann::json TabletDesk::Touched(const Json&) {
  links_.Touched();
  return Json::object();
}

nlohmann::json TabletDesk::Leave(const Json&) {
  dialogue_->Forget();
  choices_.clear();
  held_at_.reset();
  links_.Talk(false);
  return Json::object();
}

nlohmann::json TabletDesk::Map(const Json&) {
  std::string cells;
  for (const std::int8_t cell : grid_.cells) {
    cells += cell < 0 ? ' ' : cell >= OccupancyGrid::kOccupied ? '#' : '.';
  }
  return {{"width", grid_.frame.width},
          {"height", grid_.frame.height},
          {"resolution", grid_.frame.resolution},
          {"x", grid_.frame.origin_x},
          {"y", grid_.frame.origin_y},
          {"cells", cells}};
}

nlohmann::json TabletDesk::State(const Json& call) {
  Json state{{"outcome", view_.outcome},
             {"face_number", view_.face_number},
             {"pose", nullptr},
             {"language", home_language_}};
  if (view_.pose) state["pose"] = {view_.pose->x, view_.pose->y, view_.pose->yaw};
  if (call.value("face", -1) != view_.face_number) state["face"] = ToHex(view_.face);
  state["said_number"] = view_.said_number;
  if (call.value("said", -1) != view_.said_number) state["said"] = ToJson(view_.said);
  return state;
}

// The corners of the way from the robot as far as it can go, and what people are told of the rest.
nlohmann::json TabletDesk::WayTo(const std::string& place) const {
  const int index = guide_.map().Find(place);
  if (index < 0 || !view_.pose) return nullptr;
  const auto route = guide_.Whole(*view_.pose, index, Time{});
  if (!route) return nullptr;
  Json points = Json::array({{view_.pose->x, view_.pose->y}});
  const auto add = [&](int at) {
    const auto& pose = guide_.map().places()[static_cast<std::size_t>(at)].pose;
    if (pose) points.push_back({pose->x, pose->y});
  };
  add(route->start);
  bool ends_here = true;
  for (const int edge : route->edges) {
    const Edge& travelled = guide_.map().edges()[static_cast<std::size_t>(edge)];
    ends_here = ends_here && travelled.kind != EdgeKind::kElsewhere;
    if (ends_here) add(travelled.to);
  }
  const std::string words = guide_.Words(*view_.pose, index, LanguageCode(), Time{});
  return {{"points", points}, {"words", words}, {"there", ends_here}};
}

}  // namespace coppice::robot::tablet
