#include "robot_app/knowledge/answers/answer.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "robot_app/knowledge/store/opening_hours.h"

namespace coppice::robot::knowledge {
namespace {

constexpr int kMostDepartures = 3;
constexpr const char* kWeekdays[] = {"monday", "tuesday",  "wednesday", "thursday",
                                     "friday", "saturday", "sunday"};

using Values = AnswerTexts::Values;

// Answers one request; a member function for each intent.
class Answering {
 public:
  Answering(const Database& database, const AnswerTexts& texts, const Request& request,
            const AnswerContext& context)
      : database_(database),
        texts_(texts),
        request_(request),
        language_(context.language),
        now_(context.now),
        way_(context.way) {}

  Answer Find() {
    const auto time = TimeOf(database_);
    if (!time) return Text("not_now");
    time_ = &*time;
    today_ = time->Local(now_).day;
    switch (request_.intent) {
      case Intent::kFindPlace:
        return DescribePlace("place_is", Subject(Kind::kPlace));
      case Intent::kNearestPlace:
        return NearestPlace("nearest_is");
      case Intent::kListPlaces:
        return ListPlaces();
      case Intent::kFindPerson:
        return DescribeOffice();
      case Intent::kContact:
        return DescribeContact();
      case Intent::kOccupants:
        return DescribeOccupants();
      case Intent::kGuide:
        return GuideThere();
      case Intent::kMenu:
        return DescribeMenus();
      case Intent::kDepartures:
        return DescribeDepartures();
      case Intent::kOpeningHours:
        return DescribeHours();
      case Intent::kSmallTalk:
        return Talk();
      case Intent::kHelp:
        return Text("help");
      case Intent::kCancel:
        return Text("cancelled");
      case Intent::kSpeakEnglish:
      case Intent::kSpeakGerman:
        return Text("language");
      case Intent::kRepeat:
        return Text("nothing_to_repeat");
      case Intent::kYes:
      case Intent::kNo:
        return Text("nothing_asked");
    }
    return Text("unknown");
  }

 private:
  Answer Text(const std::string& key, const Values& values = {}) const {
    return {AnswerMood::kAnswered, texts_.Fill(key, values), {}, false};
  }
  std::string Subject(Kind kind) const {
    const Slot* const slot = request_.Find(kind);
    return slot ? slot->subject : std::string();
  }
  std::string Named(Kind kind, const std::string& subject) const {
    return NameOf(database_, kind, subject, language_);
  }

  // Of another building the ground floor goes without saying.
  std::string Where(const Position& position) const {
    const Values values = {{"floor", texts_.Floor(position.floor)},
                           {"building", BuildingName(database_, position.building, language_)}};
    const bool is_elsewhere = position.building != Home().building && position.floor == 0;
    return texts_.Part(is_elsewhere ? "where_building" : "where_floor", values);
  }

  Position Home() const {
    const auto site = FindSite(database_);
    const auto home = site ? FindPlace(database_, site->home) : std::nullopt;
    return home ? home->position : Position{};
  }

  Values WhereIs(const Place& place) const {
    return {{"place", Named(Kind::kPlace, place.id)}, {"where", Where(place.position)}};
  }

  // Only where the robot can drive it has a map.
  static bool CanDriveTo(const Place& place) { return place.position.at.has_value(); }

  Answer Describe(const std::string& key, const Place& place, Values values) const {
    values.merge(WhereIs(place));
    Answer answer = Text(key, values);
    const std::string& way = In(language_, place.way);
    const std::string more = CanDriveTo(place) ? texts_.Fill("can_guide") : way;
    if (!more.empty()) answer.text += " " + more;
    answer.place = place.id;
    return answer;
  }

  Answer DescribePlace(const std::string& key, const std::string& id) const {
    const auto place = FindPlace(database_, id);
    return place ? Describe(key, *place, {}) : Text("unknown");
  }

  std::vector<Place> Nearest(const std::string& category) const {
    const WayTo way = way_ ? way_() : WayTo();
    if (way) return NearestPlaces(database_, category, way);
    const Position here = Home();
    return NearestPlaces(database_, category,
                         [&here](const Place& place) { return StraightWay(here, place.position); });
  }

  Answer NearestPlace(const std::string& key) const {
    const std::string category = Subject(Kind::kCategory);
    const std::vector<Place> places = Nearest(category);
    if (places.empty()) {
      return Text("none_of_category", {{"category", Named(Kind::kCategory, category)}});
    }
    return Describe(key, places.front(), {});
  }

  Answer ListPlaces() const {
    const std::string category = Subject(Kind::kCategory);
    const std::string name = Named(Kind::kCategory, category);
    std::vector<std::string> names;
    for (const Place& place : Nearest(category)) names.push_back(Named(Kind::kPlace, place.id));
    if (names.empty()) return Text("none_of_category", {{"category", name}});
    return Text("places_are", {{"category", name},
                               {"count", std::to_string(names.size())},
                               {"places", Capitalized(texts_.List(names))}});
  }

  Answer DescribeOffice() const {
    const std::string id = Subject(Kind::kPerson);
    const auto person = FindPerson(database_, id);
    const auto place = person ? FindPlace(database_, person->office) : std::nullopt;
    const std::string name = Named(Kind::kPerson, id);
    if (!place) return Text("no_office", {{"person", name}});
    return Describe("office_is", *place, {{"person", name}});
  }

  Answer DescribeContact() const {
    const std::string id = Subject(Kind::kPerson);
    const auto person = FindPerson(database_, id);
    const bool has_phone = person && !person->phone.empty();
    const bool has_email = person && !person->email.empty();
    const char* const key = has_phone && has_email ? "phone_and_email"
                            : has_phone            ? "phone"
                            : has_email            ? "email"
                                                   : "no_contact";
    return Text(key, {{"person", Named(Kind::kPerson, id)},
                      {"phone", person ? person->phone : ""},
                      {"email", person ? person->email : ""}});
  }

  Answer DescribeOccupants() const {
    const std::string place = Subject(Kind::kPlace);
    std::vector<std::string> names;
    for (const Person& person : PeopleIn(database_, place)) {
      names.push_back(Named(Kind::kPerson, person.id));
    }
    const std::string name = Named(Kind::kPlace, place);
    if (names.empty()) return Text("no_occupants", {{"place", name}});
    return Text("occupants", {{"place", name}, {"people", texts_.List(names)}});
  }

  std::optional<Place> Goal() const {
    if (const Slot* const place = request_.Find(Kind::kPlace)) {
      return FindPlace(database_, place->subject);
    }
    if (const Slot* const person = request_.Find(Kind::kPerson)) {
      const auto found = FindPerson(database_, person->subject);
      return found ? FindPlace(database_, found->office) : std::nullopt;
    }
    const std::vector<Place> places = Nearest(Subject(Kind::kCategory));
    return places.empty() ? std::nullopt : std::optional(places.front());
  }

  Answer GuideThere() const {
    const auto place = Goal();
    if (!place) {
      if (request_.Find(Kind::kPerson)) return DescribeOffice();
      return NearestPlace("nearest_is");
    }
    if (!CanDriveTo(*place)) return Describe("cannot_guide", *place, {});
    Answer answer = Text("follow_me", {{"place", Named(Kind::kPlace, place->id)}});
    answer.place = place->id;
    answer.guides = true;
    return answer;
  }

  Day DayAsked() const { return DayMeant(Subject(Kind::kDay), today_); }

  std::string Describe(const MenuOfDay& menu, const std::string& diet, Values values) const {
    values["canteen"] = Named(Kind::kPlace, menu.canteen);
    std::vector<std::string> meals;
    for (const Meal& meal : menu.meals) meals.push_back(meal.name);
    values["meals"] = texts_.List(meals);
    const char* const key = menu.is_closed   ? "menu_closed"
                            : !meals.empty() ? (diet.empty() ? "menu" : "menu_of_diet")
                            : diet.empty()   ? "no_menu"
                                             : "menu_without";
    return texts_.Fill(key, values);
  }

  Answer DescribeMenus() const {
    const Day day = DayAsked();
    const std::string diet = Subject(Kind::kDiet);
    const Values values = {{"day", texts_.DayName(day, today_)},
                           {"diet", diet.empty() ? "" : Named(Kind::kDiet, diet)}};
    const std::vector<MenuOfDay> menus = MenusOn(database_, day, diet, language_);
    if (menus.empty()) return Text("no_menu", values);
    Answer answer;
    for (const MenuOfDay& menu : menus) {
      answer.text += (answer.text.empty() ? "" : " ") + Describe(menu, diet, values);
    }
    answer.place = menus.front().canteen;
    return answer;
  }

  std::string Describe(const Departure& departure) const {
    const LocalTime local = time_->Local(departure.when);
    const char* const key = local.day == today_ ? "departure" : "departure_later";
    std::string text = texts_.Fill(key, {{"line", departure.line},
                                         {"headsign", departure.headsign},
                                         {"time", ClockText(local.time)},
                                         {"day", texts_.DayName(local.day, today_)},
                                         {"place", Named(Kind::kPlace, departure.place)}});
    return text;
  }

  Answer DescribeDepartures() const {
    const DepartureFilter filter{Subject(Kind::kLine), Subject(Kind::kStop), Subject(Kind::kPlace)};
    const auto found = NextDepartures(database_, *time_, now_, filter, kMostDepartures);
    if (found.empty()) return Text("no_departures");
    Answer answer;
    for (const Departure& departure : found) {
      answer.text += (answer.text.empty() ? "" : " ") + Describe(departure);
    }
    answer.place = found.front().place;
    return answer;
  }

  std::string Times(const std::vector<OpenSpan>& spans) const {
    std::vector<std::string> times;
    for (const OpenSpan& span : spans) {
      if (span.to - span.from >= std::chrono::hours(24)) return texts_.Word("all_day");
      times.push_back(
          texts_.Part("from_to", {{"from", ClockText(span.from)}, {"to", ClockText(span.to)}}));
    }
    return texts_.List(times);
  }

  Answer DescribeHours() const {
    const auto place = Goal();
    if (!place) return NearestPlace("nearest_is");
    const std::string name = Named(Kind::kPlace, place->id);
    const auto hours = OpeningHours::Parse(place->hours);
    if (!hours) return Text("no_hours", {{"place", name}});
    const Day day = DayAsked();
    const auto spans = hours->On(day, IsHoliday(database_, day));
    Values values = {{"place", name}, {"day", texts_.DayName(day, today_)}};
    if (!spans.empty()) values["times"] = Times(spans);
    Answer answer = Text(spans.empty() ? "closed" : "open", values);
    answer.place = place->id;
    return answer;
  }

  Answer Talk() const {
    std::string reply = ReplyTo(database_, Subject(Kind::kTopic), language_);
    const LocalTime local = time_->Local(now_);
    for (const auto& [value, text] :
         {std::pair<std::string, std::string>{"{time}", ClockText(local.time)},
          {"{date}", texts_.Date(local.day)}}) {
      const std::size_t at = reply.find(value);
      if (at != std::string::npos) reply.replace(at, value.size(), text);
    }
    return {AnswerMood::kAnswered, reply, {}, false};
  }

  const Database& database_;
  const AnswerTexts& texts_;
  const Request& request_;
  Language language_;
  WallTime now_;
  const WayFromHere& way_;
  const SiteTime* time_ = nullptr;
  Day today_;
};

}  // namespace

const char* Word(AnswerMood mood) {
  return mood == AnswerMood::kAnswered ? "answered"
         : mood == AnswerMood::kAsking ? "asking"
                                       : "unknown";
}

Day DayMeant(const std::string& subject, Day today) {
  if (subject == "tomorrow") return today + 1;
  if (subject == "day_after_tomorrow") return today + 2;
  const auto weekday = std::find(std::begin(kWeekdays), std::end(kWeekdays), subject);
  if (weekday == std::end(kWeekdays)) return today;
  const auto wanted = static_cast<int>(weekday - std::begin(kWeekdays));
  return today + (wanted - WeekdayOf(today) + 7) % 7;
}

Answer AnswerTo(const Database& database, const AnswerTexts& texts, const Request& request,
                const AnswerContext& context) {
  return Answering(database, texts, request, context).Find();
}

}  // namespace coppice::robot::knowledge
