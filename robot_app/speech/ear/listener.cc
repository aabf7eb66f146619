#include "robot_app/speech/ear/listener.h"

#include "robot_app/knowledge/store/folded_text.h"
#include "robot_app/knowledge/store/queries.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Language;

constexpr std::size_t kMostTasks = 3;
constexpr double kServiceConfidence = 0.9;  // services tell none

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

void Listener::Listen(Sound sound, Language language, std::string who) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (tasks_.size() >= kMostTasks) tasks_.pop_front();
    tasks_.push_back({std::move(sound), {{}, language, std::move(who)}});
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
    task.heard.recognition = Recognize(task.sound, task.heard.language);
    on_heard_(task.heard);
    lock.lock();
  }
}

Recognition Listener::Recognize(const Sound& sound, Language language) {
  if (!settings_.service.url.empty() && pause_.may_be_asked()) {
    const auto text = Transcribe(settings_.service, sound, Code(language));
    if (text) return {*text, kServiceConfidence};
    pause_.Failed();
    on_problem_("the ear of the service: " + text.problem());
  }
  // Nobody has an acoustic model of another language in Debian.
  return language == Language::kEnglish ? RecognizeOffline(sound) : Recognition{};
}

Recognition Listener::RecognizeOffline(const Sound& sound) {
  if (!Prepare()) return {};
  const auto likely = LikeliestMeaning(*understander_, recognizer_->Recognize(sound));
  return {likely.text, likely.share};
}

bool Listener::Prepare() {
  const Outcome made = Refresh();
  if (!made) on_problem_("speech cannot be recognized: " + made.problem());
  return made.ok();
}

Outcome Listener::Refresh() {
  if (!database_) {
    auto database = knowledge::Database::Open(settings_.knowledge);
    if (!database) return Problem{database.problem()};
    database_.emplace(*std::move(database));
  }
  if (const Outcome loaded = LoadLanguage(); !loaded) return loaded;
  const std::int64_t version = database_->version();
  if (recognizer_ && version == version_) return {};
  const std::vector<knowledge::Name> names = knowledge::Names(*database_);
  auto made = Recognizer::Make(settings_.model, {*intents_, *words_, names, Language::kEnglish});
  if (!made) return Problem{made.problem()};
  recognizer_ = *std::move(made);
  understander_ =
      std::make_unique<knowledge::Understander>(*intents_, *words_, names, Language::kEnglish);
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
