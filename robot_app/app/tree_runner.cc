#include "robot_app/app/tree_runner.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "bt_core/data/literal.h"
#include "bt_core/live/debug/debugger.h"

namespace coppice::robot {
namespace {

// A record is never overwritten: a program that was restarted continues in a second one.
std::string FreePath(const std::filesystem::path& wanted) {
  std::filesystem::path path = wanted;
  std::error_code unknown;
  for (int number = 2; std::filesystem::exists(path, unknown); ++number) {
    path = wanted;
    path.replace_extension(std::to_string(number) + wanted.extension().string());
  }
  return path;
}

// What the step says of its failure; empty if it succeeds.
std::string WhyNot(const std::function<void()>& step) {
  try {
    step();
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace

TreeRunner::TreeRunner(std::shared_ptr<const Program> program, Clock& clock,
                       TreeRunnerOptions options)
    : options_(std::move(options)), executor_(std::move(program), clock), stream_(executor_) {
  if (options_.listener) stream_.Add(*options_.listener);
  if (!options_.record_path.empty()) no_record_ = WhyNot([this] { OpenRecord(); });
  if (options_.live_port > 0) no_live_ = WhyNot([this] { OpenSocket(); });
}

void TreeRunner::OpenRecord() {
  RecorderOptions recording;
  recording.metadata = {{"tree", options_.name}};
  const std::filesystem::path path = options_.record_path;
  std::error_code problem;
  std::filesystem::create_directories(path.parent_path(), problem);
  recorder_ = std::make_unique<Recorder>(stream_, FreePath(path), recording);
}

void TreeRunner::OpenSocket() {
  LiveOptions live;
  live.name = options_.name;
  live.port = static_cast<std::uint16_t>(options_.live_port);
  live.token = options_.live_token;
  live.read_only = live.token.empty();
  live.pictures = options_.pictures;
  live.on_note = [this](const HistoryNote& note) {
    if (recorder_) recorder_->Note(note.time, note.kind, note.text);
  };
  live_ = std::make_unique<LivePublisher>(stream_, live);
}

TreeRunner::~TreeRunner() {
  Stop();
  if (options_.listener) stream_.Remove(*options_.listener);
}

void TreeRunner::Start(std::function<void(Status)> on_end) {
  thread_ = std::thread([this, on_end = std::move(on_end)] { RunTree(on_end); });
}

void TreeRunner::RunTree(const std::function<void(Status)>& on_end) {
  while (BeginRun()) {
    const Status result = runner_->Run();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_resting_ = true;
    }
    if (runner_->stop_requested()) continue;
    on_end(result);
    return;
  }
}

// Waits as long as the tree is suspended; false if it is not to run any more.
bool TreeRunner::BeginRun() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return is_stopping_ || !is_suspended_; });
  if (is_stopping_) return false;
  runner_ = std::make_unique<Runner>(executor_, options_.run);
  is_resting_ = false;
  return true;
}

void TreeRunner::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopping_ = true;
    if (runner_) runner_->RequestStop();
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void TreeRunner::Suspend() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_suspended_ = true;
  if (runner_) runner_->RequestStop();
}

void TreeRunner::Resume() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_suspended_ = false;
  }
  changed_.notify_one();
}

bool TreeRunner::IsAlive() {
  const bool answered = answered_->exchange(false);
  if (answered) executor_.inbox()->PostCall([answer = answered_] { answer->store(true); });
  return answered || IsResting();
}

bool TreeRunner::IsResting() {
  if (live_ && live_->debugger().where().where != DebugStop::Where::kNowhere) return true;
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_resting_;
}

std::string TreeRunner::RecordTrouble() const {
  return recorder_ ? recorder_->trouble() : no_record_;
}

void TreeRunner::Note(const std::string& kind, const std::string& text) {
  if (recorder_) recorder_->Note(executor_.clock().Now(), kind, text);
}

Outcome SetKey(Executor& executor, const std::string& key, const std::string& text) {
  const Layout& layout = executor.program().layout;
  const SlotIndex slot = layout.Find(kMainScope, key);
  if (slot == kNoSlot) {
    std::vector<std::string> keys;
    for (const SlotDefinition& definition : layout.slots) {
      if (definition.scope == 0 && !definition.key.empty()) keys.push_back(definition.key);
    }
    return Problem{"the tree has no key \"" + key + "\" " + DidYouMean(key, keys)};
  }
  const Type* type = layout.slots[slot].type;
  Value value;
  if (!type) {
    value = GuessValue(text);
  } else if (!value.Parse(*type, text)) {
    return Problem{"\"" + text + "\" is not a value for key \"" + key + "\", expected " +
                   type->name};
  }
  executor.inbox()->Post(slot, 0, std::move(value));
  return {};
}

}  // namespace coppice::robot
