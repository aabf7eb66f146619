#include "robot_app/speech/ear/listener.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "robot_app/knowledge/store/folded_text.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/speech/endpoint/understanding_service.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Language;

constexpr std::size_t kMostTasks = 3;
// All services together, then it goes on offline.
constexpr std::chrono::milliseconds kLongest{1800};
constexpr std::chrono::milliseconds kShortest{200};  // worth asking at all

}  // namespace

Listener::Listener(ListenerSettings settings, OnHeard on_heard, OnProblem on_problem)
    : settings_(std::move(settings)),
      on_heard_(std::move(on_heard)),
      on_problem_(std::move(on_problem)),
      thread_([this] { Run(); }) {}

Listener::~Listener() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Listener::Listen(Utterance utterance, Language language, std::string who,
                      std::vector<std::string> expected) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!tasks_.empty() && !tasks_.back().utterance.has_ended) tasks_.pop_back();
    if (tasks_.size() >= kMostTasks) tasks_.pop_front();
    tasks_.push_back({std::move(utterance),
                      {{}, language, std::move(who), {}, {}, {}},
                      std::move(expected),
                      std::chrono::steady_clock::now()});
  }
  changed_.notify_all();
}

void Listener::Run() {
  if (settings_.prepares) Prepare();
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || !tasks_.empty(); });
    if (stop_) return;
    Task task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    if (task.utterance.has_ended) {
      const Instant begin = std::chrono::steady_clock::now();
      task.heard.alternatives = Recognize(task);
      task.heard.told = AskWhatIsMeant(task.heard, begin);
      Tell(std::move(task.heard), task.begin);
    } else {
      Foresee(std::move(task));
    }
    lock.lock();
  }
}

void Listener::Tell(HeardUtterance heard, Instant begin) const {
  heard.took = std::chrono::steady_clock::now() - begin;
  on_heard_(heard);
}

// Services are asked once for an utterance.
void Listener::Foresee(Task task) {
  foreseen_.reset();
  if (MayAskService() || task.heard.language != Language::kEnglish) return;
  task.heard.alternatives = RecognizeOffline(task);
  foreseen_ = std::move(task);
  if (!IsAllSaid(*foreseen_)) return;
  HeardUtterance heard = foreseen_->heard;
  heard.pause = foreseen_->utterance.pause;
  Tell(std::move(heard), foreseen_->begin);
}

// An answer to a question is short, and often goes on: "no, the second one".
bool Listener::IsAllSaid(const Task& task) const {
  return settings_.ends_early && settings_.understanding.url.empty() && complete_ &&
         task.expected.empty() && complete_->IsSaid(task.heard.alternatives, settings_.least_sure);
}

bool Listener::IsForeseen(const Task& task) const {
  return foreseen_ && foreseen_->utterance.sound.samples == task.utterance.sound.samples &&
         foreseen_->expected == task.expected;
}

bool Listener::MayAskService() const {
  return !settings_.service.url.empty() && pause_.may_be_asked();
}

std::vector<knowledge::Alternative> Listener::Recognize(const Task& task) {
  const Language language = task.heard.language;
  if (MayAskService()) {
    const auto text = Transcribe(settings_.service, task.utterance.sound, Code(language));
    if (text) return {{*text, 1}};
    pause_.Failed();
    on_problem_("the ear of the service: " + text.problem());
  }
  // Nobody has an acoustic model of another language in Debian.
  if (language != Language::kEnglish) return {};
  return RecognizeOffline(task);
}

std::optional<knowledge::ToldMeaning> Listener::AskWhatIsMeant(const HeardUtterance& heard,
                                                               Instant begin) {
  SpeechService service = settings_.understanding;
  const auto& texts = heard.alternatives;
  const bool is_sure = !texts.empty() && texts.front().chance >= knowledge::kSureEnough;
  const auto left = kLongest - std::chrono::duration_cast<std::chrono::milliseconds>(
                                   std::chrono::steady_clock::now() - begin);
  service.timeout = std::min(service.timeout, left);
  const bool may_ask = !service.url.empty() && understanding_pause_.may_be_asked();
  if (!may_ask || !is_sure || left < kShortest || !LoadLanguage()) return std::nullopt;
  auto told = AskMeaning(service, texts.front().text, heard.language, *intents_);
  if (told) return *std::move(told);
  understanding_pause_.Failed();
  on_problem_("the understanding of the service: " + told.problem());
  return std::nullopt;
}

// Who was asked something may also ask something new.
std::vector<knowledge::Alternative> Listener::RecognizeOffline(const Task& task) {
  if (!Prepare()) return {};
  if (IsForeseen(task)) return foreseen_->heard.alternatives;
  const Sound& sound = task.utterance.sound;
  if (!task.expected.empty()) {
    auto replies = recognizer_->RecognizeReply(sound, task.expected);
    if (!replies.empty()) return replies;
  }
  return recognizer_->Recognize(sound);
}

bool Listener::Prepare() {
  const Outcome made = Refresh();
  if (!made) on_problem_("speech cannot be recognized: " + made.problem());
  return made.ok();
}

Outcome Listener::Refresh() {
  if (!database_) {
    std::error_code error;
    auto database = std::filesystem::exists(settings_.knowledge, error)
                        ? knowledge::Database::OpenOrCopy(settings_.knowledge)
                        : knowledge::Database::Open(settings_.knowledge);
    if (!database) return Problem{database.problem()};
    database_.emplace(*std::move(database));
  }
  if (const Outcome loaded = LoadLanguage(); !loaded) return loaded;
  const std::int64_t version = database_->version();
  if (recognizer_ && version == version_) return {};
  recognizer_.reset();
  foreseen_.reset();
  names_ = knowledge::Names(*database_);
  const SpokenLanguage spoken{*intents_, *words_, names_, Language::kEnglish};
  auto made = Recognizer::Make(settings_.model, spoken);
  if (!made) return Problem{made.problem()};
  complete_ = std::make_unique<CompleteRequest>(spoken);
  recognizer_ = *std::move(made);
  version_ = version;
  return {};
}

Outcome Listener::LoadLanguage() {
  if (intents_) return {};
  Diagnostics diagnostics;
  auto intents =
      knowledge::LoadIntentTable(settings_.language_folder + "/intents.yaml", diagnostics);
  auto words =
      knowledge::LoadLanguageWords(settings_.language_folder, Language::kEnglish, diagnostics);
  if (diagnostics.has_errors()) return Problem{diagnostics.ToString()};
  words_ = std::move(words);
  intents_ = std::move(intents);
  return {};
}

}  // namespace coppice::robot::speech
