#include "robot_app/storage/spool/intake.h"

#include <pthread.h>

#include <algorithm>
#include <stdexcept>

#include "bt_core/model/utf8.h"

namespace coppice::robot::storage {
namespace {

constexpr const char* kNoRoom = "the spool could not be written";
constexpr const char* kOther = "other reasons";
constexpr std::size_t kMostReasons = 20;  // of a topic
constexpr std::size_t kLongestReason = 200;

}  // namespace

Intake::Intake(Spool& spool, const IntakeLimits& limits, std::function<void()> on_stored)
    : spool_(spool), limits_(limits), on_stored_(std::move(on_stored)) {
  thread_ = std::thread([this] { Run(); });
}

Intake::~Intake() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  end_.notify_one();
  thread_.join();
}

void Intake::Put(Document document) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t now = document.received;
  Append(std::move(document));
  MakeRoom(now);
}

void Intake::Lose(const std::string& topic, const std::string& reason, std::int64_t now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  CountLoss(topic, reason, now);
}

IntakeState Intake::Look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  IntakeState state = state_;
  for (const auto& documents : waiting_) state.documents += documents.size();
  return state;
}

void Intake::Append(Document document) {
  bytes_ += document.json.size();
  const auto priority = static_cast<std::size_t>(std::clamp(document.priority, 0, 9));
  waiting_[priority].push_back(std::move(document));
}

void Intake::MakeRoom(std::int64_t now) {
  for (auto& documents : waiting_) {
    while (bytes_ > limits_.largest && !documents.empty()) {
      CountLoss(documents.front().topic, kNoRoom, now);
      bytes_ -= documents.front().json.size();
      documents.pop_front();
    }
  }
}

void Intake::CountLoss(const std::string& topic, const std::string& reason, std::int64_t now) {
  const std::string why = Reason(topic, reason);
  Loss& loss = losses_[{topic, why}];
  if (loss.count == 0) loss = {topic, why, 0, now, now};
  ++loss.count;
  loss.last = now;
  ++state_.lost;
}

// Whoever sends messages that cannot be understood has a say in the reason.
std::string Intake::Reason(const std::string& topic, const std::string& reason) {
  std::string plain = PlainText(reason, kLongestReason);
  std::set<std::string>& known = reasons_[topic];
  if (known.size() >= kMostReasons && known.count(plain) == 0) return kOther;
  known.insert(plain);
  return plain;
}

std::vector<Document> Intake::TakeDocuments() {
  std::vector<Document> taken;
  for (auto& documents : waiting_) {
    std::move(documents.begin(), documents.end(), std::back_inserter(taken));
    documents.clear();
  }
  bytes_ = 0;
  return taken;
}

std::vector<Loss> Intake::TakeLosses() {
  std::vector<Loss> taken;
  for (auto& [key, loss] : losses_) taken.push_back(std::move(loss));
  losses_.clear();
  return taken;
}

// Before what has come meanwhile.
void Intake::PutBack(std::vector<Document> documents, std::vector<Loss> losses,
                     const char* problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto document = documents.rbegin(); document != documents.rend(); ++document) {
    bytes_ += document->json.size();
    waiting_[static_cast<std::size_t>(std::clamp(document->priority, 0, 9))].push_front(
        std::move(*document));
  }
  for (const Loss& loss : losses) {
    Loss& now = losses_[{loss.topic, loss.reason}];
    const std::int64_t later = now.count;
    now = {loss.topic, loss.reason, loss.count + later, loss.first, std::max(loss.last, now.last)};
  }
  state_.problem = problem;
}

void Intake::Commit() {
  std::unique_lock<std::mutex> lock(mutex_);
  std::vector<Document> documents = TakeDocuments();
  std::vector<Loss> losses = TakeLosses();
  lock.unlock();
  if (documents.empty() && losses.empty()) return;
  try {
    spool_.Add(documents, losses);
  } catch (const std::runtime_error& error) {
    return PutBack(std::move(documents), std::move(losses), error.what());
  }
  lock.lock();
  state_.stored += documents.size();
  state_.problem.clear();
  lock.unlock();
  on_stored_();
}

void Intake::Run() {
  pthread_setname_np(pthread_self(), "store_intake");
  bool goes_on = true;
  while (goes_on) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      goes_on = !end_.wait_for(lock, limits_.period, [this] { return is_ending_; });
      ++state_.rounds;
    }
    Commit();
  }
}

}  // namespace coppice::robot::storage
