#include "robot_app/speech/mouth/mouth.h"

#include <algorithm>
#include <exception>
#include <functional>

namespace coppice::robot::speech {
namespace {

constexpr const char* kTooMuch = "too much waits to be said";

template <class Future>
bool IsReady(const Future& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

// A sound that there is no memory for, or whatever else goes wrong, does not end the program.
Expected<Speech> Made(const Synthesize& synthesize, const std::string& text,
                      const std::string& language) {
  try {
    return synthesize(text, language);
  } catch (const std::exception& error) {
    return Problem{std::string("the sound cannot be made: ") + error.what()};
  }
}

}  // namespace

void Mouth::Add(Saying saying) {
  if (sayings_.size() > kMostWaiting && sayings_.back().priority >= saying.priority) {
    events_.push_back({saying.id, MouthEvent::Kind::kFailed, {}, kTooMuch});
    return;
  }
  if (sayings_.size() > kMostWaiting) {
    Drop(sayings_.size() - 1, MouthEvent::Kind::kFailed, kTooMuch);
  }
  const bool is_more_urgent = !sayings_.empty() && saying.priority > sayings_.front().priority;
  if (is_more_urgent) {
    Stop();
    Drop(0, MouthEvent::Kind::kCut);
  }
  const auto behind = std::find_if(sayings_.begin(), sayings_.end(), [&](const Saying& other) {
    return other.priority < saying.priority;
  });
  const bool is_first = behind == sayings_.begin();
  sayings_.insert(behind, std::move(saying));
  if (is_first) Begin();
}

void Mouth::Cancel(std::int64_t id) {
  const auto found = std::find_if(sayings_.begin(), sayings_.end(),
                                  [id](const Saying& saying) { return saying.id == id; });
  if (found == sayings_.end()) return;
  const bool is_current = found == sayings_.begin();
  if (is_current) Stop();
  Drop(static_cast<std::size_t>(found - sayings_.begin()), MouthEvent::Kind::kCancelled);
  if (is_current) Begin();
}

std::vector<MouthEvent> Mouth::Update() {
  abandoned_.erase(std::remove_if(abandoned_.begin(), abandoned_.end(),
                                  [](const auto& making) { return IsReady(making); }),
                   abandoned_.end());
  if (making_.valid() && IsReady(making_)) Synthesized();
  if (is_playing_) Follow();
  if (!making_.valid() && !is_playing_) Begin();
  return std::exchange(events_, {});
}

// Makes the sound of the first one, if not too many others are still being made: then Update does.
void Mouth::Begin() {
  if (sayings_.empty() || abandoned_.size() >= kMostAbandoned) return;
  const Saying& saying = sayings_.front();
  making_ =
      std::async(std::launch::async, &Made, std::cref(synthesize_), saying.text, saying.language);
}

void Mouth::Stop() {
  if (making_.valid()) abandoned_.push_back(std::move(making_));
  making_ = {};
  if (is_playing_) output_.Stop();
  is_playing_ = false;
}

void Mouth::Drop(std::size_t index, MouthEvent::Kind kind, std::string message) {
  events_.push_back({sayings_[index].id, kind, {}, std::move(message)});
  sayings_.erase(sayings_.begin() + static_cast<std::ptrdiff_t>(index));
}

void Mouth::Synthesized() {
  Expected<Speech> made = making_.get();
  const Outcome started = made ? output_.Start(made->sound) : Outcome(Problem{made.problem()});
  if (!started) {
    Drop(0, MouthEvent::Kind::kFailed, started.problem());
    return Begin();
  }
  speech_ = *std::move(made);
  next_word_ = 0;
  is_playing_ = true;
}

void Mouth::Follow() {
  const double played = output_.Played();
  while (next_word_ < speech_.words.size() && speech_.words[next_word_].second <= played) {
    events_.push_back(
        {sayings_.front().id, MouthEvent::Kind::kWord, speech_.words[next_word_++], {}});
  }
  if (played < speech_.sound.seconds()) return;
  Stop();
  Drop(0, MouthEvent::Kind::kPlayed);
  Begin();
}

}  // namespace coppice::robot::speech
