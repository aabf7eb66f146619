#include "robot_app/knowledge/understanding/likeliest_meaning.h"

#include <algorithm>

namespace coppice::robot::knowledge {
namespace {

struct Meaning {
  Understanding understanding;
  double chance = 0;
  const Alternative* likeliest = nullptr;

  void Add(const Alternative& alternative) {
    chance += alternative.chance;
    if (!likeliest || alternative.chance > likeliest->chance) likeliest = &alternative;
  }
};

bool IsSame(const std::vector<Slot>& a, const std::vector<Slot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Slot& x, const Slot& y) {
    return x.kind == y.kind && x.subject == y.subject;
  });
}

bool IsSame(const Understanding& a, const Understanding& b) {
  if (a.verdict != b.verdict) return false;
  if (a.verdict == Verdict::kUnknown) return true;
  return a.request.intent == b.request.intent && IsSame(a.request.slots, b.request.slots) &&
         IsSame(a.choices, b.choices);
}

}  // namespace

LikelyText LikeliestMeaning(const Understander& understander,
                            const std::vector<Alternative>& alternatives) {
  std::vector<Meaning> meanings;
  double sum = 0;
  for (const Alternative& alternative : alternatives) {
    sum += alternative.chance;
    Understanding understood = understander.Understand(alternative.text);
    auto same = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& meaning) {
      return IsSame(meaning.understanding, understood);
    });
    if (same == meanings.end()) {
      meanings.emplace_back();
      same = std::prev(meanings.end());
      same->understanding = std::move(understood);
    }
    same->Add(alternative);
  }
  const auto best =
      std::max_element(meanings.begin(), meanings.end(),
                       [](const Meaning& a, const Meaning& b) { return a.chance < b.chance; });
  if (best == meanings.end() || sum <= 0) return {};
  return {best->likeliest->text, best->chance / sum};
}

}  // namespace coppice::robot::knowledge
