#include "robot_app/knowledge/understanding/likely_meanings.h"

#include <algorithm>
#include <iterator>

namespace coppice::robot::knowledge {
namespace {

constexpr std::size_t kMostAsked = 2;
// Of the chance of what was understood although words are left: that it is something else.
constexpr double kDoubt = 0.3;

bool IsSame(const Understanding& a, const Understanding& b) {
  if (a.verdict != b.verdict) return false;
  return a.verdict == Verdict::kUnknown || (a.request == b.request && a.choices == b.choices);
}

}  // namespace

std::vector<Request> RequestsOf(const Understanding& meant) {
  if (meant.verdict == Verdict::kUnderstood) return {meant.request};
  std::vector<Request> requests;
  for (const Slot& choice : meant.choices) {
    requests.push_back(meant.request);
    auto& slots = requests.back().slots;
    slots.insert(slots.begin(), choice);
  }
  return requests;
}

std::vector<Meaning> LikelyMeanings(const Understander& understander,
                                    const std::vector<Alternative>& alternatives) {
  std::vector<Meaning> meanings;
  std::vector<double> likeliest;  // of the texts of each
  double sum = 0;
  for (const Alternative& alternative : alternatives) {
    sum += alternative.chance;
    Understanding understood = understander.Understand(alternative.text);
    // Not what was said for sure, nor what cannot be asked back, or is asked back anyway.
    const bool is_doubtful = alternatives.size() > 1 && !understood.unknown.empty() &&
                             understood.verdict == Verdict::kUnderstood &&
                             CanBeAsked(understood.request.intent);
    const auto same = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& meaning) {
      return IsSame(meaning.understanding, understood);
    });
    const auto at = static_cast<std::size_t>(same - meanings.begin());
    if (same == meanings.end()) {
      meanings.push_back({std::move(understood), "", 0, 0});
      likeliest.push_back(-1);
    }
    meanings[at].share += alternative.chance;
    meanings[at].sure += (is_doubtful ? 1 - kDoubt : 1) * alternative.chance;
    if (alternative.chance <= likeliest[at]) continue;
    likeliest[at] = alternative.chance;
    meanings[at].text = alternative.text;
  }
  if (sum <= 0) return {};
  for (Meaning& meaning : meanings) {
    meaning.share /= sum;
    meaning.sure /= sum;
  }
  std::stable_sort(meanings.begin(), meanings.end(),
                   [](const Meaning& a, const Meaning& b) { return a.share > b.share; });
  return meanings;
}

bool CanBeAsked(Intent intent) {
  switch (intent) {
    case Intent::kSmallTalk:
    case Intent::kRepeat:
    case Intent::kCancel:
    case Intent::kYes:
    case Intent::kNo:
    case Intent::kSpeakEnglish:
    case Intent::kSpeakGerman:
      return false;
    default:
      return true;
  }
}

std::vector<Request> WorthAsking(const std::vector<Meaning>& meanings, double least_sure) {
  std::vector<Request> asked;
  if (meanings.empty() || meanings.front().sure >= least_sure) return asked;
  const bool is_unknown = meanings.front().understanding.verdict == Verdict::kUnknown;
  const double least = is_unknown ? kWorthAskingThough : kWorthAsking;
  for (const Meaning& meaning : meanings) {
    if (meaning.share < least) break;
    if (!CanBeAsked(meaning.understanding.request.intent)) continue;
    for (Request& request : RequestsOf(meaning.understanding)) {
      if (asked.size() < kMostAsked) asked.push_back(std::move(request));
    }
  }
  return asked;
}

}  // namespace coppice::robot::knowledge
