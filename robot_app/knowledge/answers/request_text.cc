#include "robot_app/knowledge/answers/request_text.h"

#include <algorithm>

#include "robot_app/knowledge/answers/answer.h"

namespace coppice::robot::knowledge {
namespace {

bool IsSubject(Kind kind) {
  return kind == Kind::kPlace || kind == Kind::kPerson || kind == Kind::kCategory;
}

// Of a connection the place is where it begins, one more of the details.
const Slot* SubjectOf(const Request& request) {
  if (request.intent == Intent::kDepartures) return nullptr;
  const auto found = std::find_if(request.slots.begin(), request.slots.end(),
                                  [](const Slot& slot) { return IsSubject(slot.kind); });
  return found == request.slots.end() ? nullptr : &*found;
}

}  // namespace

std::string RequestText(const Database& database, const AnswerTexts& texts, const Request& request,
                        Language language, Day today) {
  const Slot* const subject = SubjectOf(request);
  std::string about, details;
  for (const Slot& slot : request.slots) {
    std::string name = slot.kind == Kind::kDay
                           ? texts.DayName(DayMeant(slot.subject, today), today)
                           : NameOf(database, slot.kind, slot.subject, language);
    if (slot.kind == Kind::kLine) name = texts.Part("asks_line", {{"line", name}});
    if (&slot == subject) {
      about = name;
    } else {
      details += (details.empty() ? ": " : ", ") + name;
    }
  }
  return texts.Part("asks_" + std::string(Word(request.intent)), {{"about", about}}) + details;
}

bool DifferByName(const std::vector<Request>& requests) {
  if (requests.size() < 2 || requests.front().slots.empty()) return false;
  const Request& first = requests.front();
  return std::all_of(requests.begin() + 1, requests.end(), [&](const Request& request) {
    return request.intent == first.intent && request.slots.size() == first.slots.size() &&
           IsSubject(request.slots.front().kind) &&
           std::equal(first.slots.begin() + 1, first.slots.end(), request.slots.begin() + 1);
  });
}

}  // namespace coppice::robot::knowledge
