#include "editor/simulation/simulator.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "bt_core/testing/random_suite.h"
#include "editor/live/key_writes.h"
#include "editor/live/live_queue.h"
#include "editor/simulation/open_tree.h"

namespace coppice::editor {
namespace {

constexpr double kCompileDelay = 0.15;  // seconds behind the last edit
constexpr int kMostTicksPerUpdate = 500;

// Of the scenarios that lie beside the tree; nothing if they name none.
std::optional<Project> ReadModels(OpenProject& files, const std::string& path,
                                  const std::string& tree_id, Diagnostics& diagnostics) {
  Diagnostics unsaid;  // the tree is compiled afterwards, and says it
  const std::optional<Project> project = ReadOpenProject(files, path, unsaid);
  if (!project) return std::nullopt;
  const bool is_main = tree_id.empty() || tree_id == project->main_tree();
  const auto suite =
      RandomSuiteBeside(path, is_main ? project->main_tree() : tree_id, is_main, diagnostics);
  if (!suite || suite->models_file.empty()) return std::nullopt;
  return Project::FromFile(suite->models_file, diagnostics);
}

KeyValue KeyValueOf(const LiveCommand& command) {
  const std::string key = command.scope.empty() ? command.key : command.scope + "/" + command.key;
  if (const std::optional<std::string> text = TextOf(command)) {
    return {{}, key, *text, KeyValue::Kind::kString};
  }
  return {{}, key, command.value, KindOfText(command.value)};
}

double Seconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-9; }

}  // namespace

struct Simulator::Stage {
  LiveQueue queue{nullptr};
  std::optional<Simulation> simulation;  // nothing when its run is closed
};

class Simulator::Source final : public RunSource {
 public:
  explicit Source(std::shared_ptr<Stage> stage) : stage_(std::move(stage)) {}
  ~Source() override { stage_->simulation.reset(); }

  const std::string& name() const override { return name_; }
  bool is_robot() const override { return false; }
  bool is_simulation() const override { return true; }
  void Pump(LiveListener& listener) override { stage_->queue.Deliver(listener); }
  bool has_news() const override { return !stage_->queue.empty(); }

  void Send(LiveCommand command, LiveClient::ReplyHandler on_reply) override {
    Outcome done = Problem{"a simulation has commands of its own: Ctrl+P, \"Simulation\""};
    if (command.kind == LiveCommand::Kind::kWrite) {
      done = stage_->simulation->SetKey(KeyValueOf(command));
    }
    if (on_reply) on_reply(done ? LiveReply(HookAnswer{}) : Problem{done.problem()});
  }

 private:
  const std::string name_ = kName;
  const std::shared_ptr<Stage> stage_;
};

std::unique_ptr<RunSource> Simulator::Start(OpenProject& files, const std::string& path,
                                            const std::string& tree_id, Diagnostics& diagnostics) {
  Diagnostics of_scenarios;
  std::optional<Project> models = ReadModels(files, path, tree_id, of_scenarios);
  auto program = CompileOpenTree(files, path, tree_id, models ? &*models : nullptr, diagnostics);
  if (!program) return nullptr;
  diagnostics.Append(of_scenarios);
  path_ = path;
  models_ = std::move(models);
  tree_id_ = program->trees[0].id == program->main_tree ? "" : program->trees[0].id;
  is_playing_ = false;
  result_.reset();
  problem_.clear();
  version_ = files.version();
  compile_at_.reset();
  stage_ = std::make_shared<Stage>();
  stage_->simulation.emplace(std::move(program), stage_->queue);
  return std::make_unique<Source>(stage_);
}

std::optional<RandomPlay> Simulator::ReadRandomPlay(Diagnostics& diagnostics) const {
  const Program& program = *get()->program();
  auto suite = RandomSuiteBeside(path_, program.trees[0].id, tree_id_.empty(), diagnostics);
  if (!suite || !CheckPlay(program, *suite->random, diagnostics)) return std::nullopt;
  return std::move(suite->random);
}

Simulation* Simulator::get() const {
  return stage_ && stage_->simulation ? &*stage_->simulation : nullptr;
}

void Simulator::Play() {
  is_playing_ = true;
  due_ = 0;
}

void Simulator::SetSpeed(double speed) { speed_ = std::clamp(speed, 0.1, 1000.0); }

void Simulator::SetPeriod(Duration period) {
  period_ = std::clamp<Duration>(period, std::chrono::milliseconds(1), std::chrono::seconds(10));
}

void Simulator::SetResult(Status status) {
  const bool is_done = IsCompleted(status) && !get()->is_begun_anew();
  result_ = is_done ? std::optional(status) : std::nullopt;
  if (result_) is_playing_ = false;
}

void Simulator::Update(OpenProject& files, double now) {
  const double passed = std::max(now - now_, 0.0);
  now_ = now;
  if (!get()) return;
  ReloadIfEdited(files, now);
  if (!is_playing_) return;
  due_ += passed * speed_;
  const double step = Seconds(period_);
  for (int ticks = 0; is_playing_ && due_ >= step; due_ -= step) {
    if (++ticks > kMostTicksPerUpdate) {
      due_ = 0;  // faster than this computer can
      break;
    }
    SetResult(get()->Tick(period_));
  }
}

double Simulator::NextUpdateIn(double now) const {
  if (!get()) return std::numeric_limits<double>::infinity();
  if (is_playing_) return std::max((Seconds(period_) - due_) / speed_, 0.0);
  return compile_at_ ? std::max(*compile_at_ - now, 0.0) : std::numeric_limits<double>::infinity();
}

void Simulator::ReloadIfEdited(OpenProject& files, double now) {
  if (files.version() != version_) {
    version_ = files.version();
    compile_at_ = now + kCompileDelay;
  }
  if (!compile_at_ || now < *compile_at_) return;
  compile_at_.reset();
  Diagnostics diagnostics;
  auto program =
      CompileOpenTree(files, path_, tree_id_, models_ ? &*models_ : nullptr, diagnostics);
  problem_ = program ? "" : diagnostics.ToString();
  if (program && !IsSameText(*program)) get()->Reload(std::move(program));
}

bool Simulator::IsSameText(const Program& program) const {
  const auto& texts = program.texts;
  const auto& before = get()->program()->texts;
  return std::equal(texts.begin(), texts.end(), before.begin(), before.end(),
                    [](const SourceText& a, const SourceText& b) {
                      return a.file() == b.file() && a.text() == b.text();
                    });
}

}  // namespace coppice::editor
