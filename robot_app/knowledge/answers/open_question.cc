#include "robot_app/knowledge/answers/open_question.h"

#include <algorithm>

namespace coppice::robot::knowledge {
namespace {

bool Has(const Request& request, const Candidate& candidate) {
  return std::find(request.slots.begin(), request.slots.end(),
                   Slot{candidate.kind, candidate.subject}) != request.slots.end();
}

}  // namespace

std::optional<Request> OpenQuestion::AnsweredBy(std::string_view text,
                                                const Understander& understander,
                                                const LanguageWords& words) const {
  const Understanding heard = understander.Understand(text);
  const bool is_whole = heard.verdict == Verdict::kUnderstood;
  const Intent intent = heard.request.intent;
  if (is_whole && heard.request.slots.empty()) {
    if (intent == Intent::kNo || intent == Intent::kCancel) return Request{Intent::kCancel, {}};
    if (intent == Intent::kYes && choices_.size() == 1) return choices_.front().request;
  }
  if (choices_.empty()) return Completed(text, understander);
  if (auto chosen = ByNumber(text, words)) return chosen;
  if (auto chosen = ByName(text, understander)) return chosen;
  for (const Choice& choice : choices_) {
    if (is_whole && choice.request == heard.request) return choice.request;
  }
  const bool is_bare = heard.verdict != Verdict::kUnknown && heard.request.slots.empty();
  return is_bare && heard.choices.empty() ? ByIntent(intent) : std::nullopt;
}

std::optional<LikelyReply> OpenQuestion::AnsweredBy(const std::vector<Alternative>& alternatives,
                                                    const Understander& understander,
                                                    const LanguageWords& words) const {
  std::vector<LikelyReply> replies;
  double sum = 0;
  for (const Alternative& alternative : alternatives) {
    sum += alternative.chance;
    const auto request = AnsweredBy(alternative.text, understander, words);
    if (!request) continue;
    const auto same = std::find_if(replies.begin(), replies.end(), [&](const LikelyReply& reply) {
      return reply.request == *request;
    });
    if (same == replies.end()) {
      replies.push_back({*request, alternative.text, alternative.chance});
    } else {
      same->share += alternative.chance;
    }
  }
  for (LikelyReply& reply : replies) {
    reply.share /= sum;
    if (reply.share >= kSureReply) return std::move(reply);
  }
  return std::nullopt;
}

// What is missing is filled with the name that fits better than all others.
std::optional<Request> OpenQuestion::Completed(std::string_view text,
                                               const Understander& understander) const {
  std::vector<Candidate> found = understander.FindNames(text, kinds_);
  found.erase(std::remove_if(found.begin(), found.end(),
                             [](const Candidate& candidate) { return candidate.fit < kSureName; }),
              found.end());
  if (found.empty() || (found.size() > 1 && found[1].value >= kAsGoodName * found[0].value)) {
    return std::nullopt;
  }
  Request request = request_;
  request.slots.insert(request.slots.begin(), {found[0].kind, found[0].subject});
  return request;
}

std::optional<Request> OpenQuestion::ByNumber(std::string_view text,
                                              const LanguageWords& words) const {
  for (const std::string& word : SplitWords(text)) {
    const auto ordinal = words.ordinals.find(word);
    if (ordinal == words.ordinals.end() || ordinal->second >= choices_.size()) continue;
    return choices_[ordinal->second].request;
  }
  return std::nullopt;
}

// The only choice that has the name that fits best.
std::optional<Request> OpenQuestion::ByName(std::string_view text,
                                            const Understander& understander) const {
  const Choice* best = nullptr;
  double best_value = 0;
  for (const Candidate& candidate : understander.FindNames(text, {kKinds.begin(), kKinds.end()})) {
    for (const Choice& choice : choices_) {
      if (!Has(choice.request, candidate)) continue;
      if (best == nullptr) {
        best = &choice;
        best_value = candidate.value;
      } else if (best != &choice && candidate.value >= kAsGoodName * best_value) {
        return std::nullopt;
      }
    }
  }
  return best ? std::optional(best->request) : std::nullopt;
}

std::optional<Request> OpenQuestion::ByIntent(Intent intent) const {
  const Choice* found = nullptr;
  for (const Choice& choice : choices_) {
    if (choice.request.intent != intent) continue;
    if (found != nullptr) return std::nullopt;
    found = &choice;
  }
  return found ? std::optional(found->request) : std::nullopt;
}

}  // namespace coppice::robot::knowledge
