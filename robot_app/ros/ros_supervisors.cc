#include "robot_app/ros/ros_supervisors.h"

#include <coppice_msgs/AskForHelp.h>
#include <coppice_msgs/TellSupervisors.h>
#include <coppice_msgs/WithdrawHelp.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "robot_app/common/service_call.h"

namespace coppice::robot::adapters {
namespace {

using coppice_msgs::HelpRequest;

constexpr std::chrono::seconds kRetryAfter{1};

const HelpRequest* Find(const coppice_msgs::HelpRequests& list, std::uint32_t id) {
  const auto found = std::find_if(list.requests.begin(), list.requests.end(),
                                  [id](const HelpRequest& request) { return request.id == id; });
  return found == list.requests.end() ? nullptr : &*found;
}

}  // namespace

RosSupervisors::RosSupervisors(ros::NodeHandle& node)
    : subscriber_(node.subscribe<coppice_msgs::HelpRequests>(
          "/assistance/requests", 10,
          [this](const coppice_msgs::HelpRequests::ConstPtr& list) {
            const std::lock_guard<std::mutex> lock(mutex_);
            list_ = list;
            Look();
          })),
      worker_([this] { Work(); }) {}

RosSupervisors::~RosSupervisors() {
  subscriber_.shutdown();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  worker_.join();
}

void RosSupervisors::Ask(const std::string& subject, const std::string& question,
                         Sender<leaves::ActionResult> done) {
  const std::lock_guard<std::mutex> lock(mutex_);
  open_[subject] = {question, done, 0, ++editions_};
  changed_.notify_one();
}

void RosSupervisors::Withdraw(const std::string& subject) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (open_.erase(subject) == 0) return;
  Enqueue([subject] {
    coppice_msgs::WithdrawHelp service;
    service.request.subject = subject;
    return CallService("/assistance/withdraw", service);
  });
}

void RosSupervisors::Tell(const std::string& subject, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Enqueue([subject, message] {
    coppice_msgs::TellSupervisors service;
    service.request.subject = subject;
    service.request.message = message;
    return CallService("/assistance/tell", service);
  });
}

void RosSupervisors::Enqueue(Call call) {
  if (calls_.size() >= kMostWaiting) calls_.pop_front();
  calls_.push_back(std::move(call));
  changed_.notify_one();
}

void RosSupervisors::Work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stop_) {
    if (!Do(lock)) changed_.wait_for(lock, kRetryAfter, [this] { return stop_; });
  }
}

// What was withdrawn comes before new questions, so that a subject that is asked about again stays
// open. False: try again later.
bool RosSupervisors::Do(std::unique_lock<std::mutex>& lock) {
  const bool is_queued = !calls_.empty();
  const Call call = is_queued ? calls_.front() : NextQuestion();
  if (!call) {
    changed_.wait(lock);
    return true;
  }
  if (is_queued) calls_.pop_front();
  lock.unlock();
  const bool ok = call();
  lock.lock();
  if (!ok && is_queued && calls_.size() < kMostWaiting) calls_.push_front(call);
  return ok;
}

RosSupervisors::Call RosSupervisors::NextQuestion() {
  for (const auto& [subject, open] : open_) {
    if (open.id == 0) return MakeAsk(subject, open);
  }
  return nullptr;
}

RosSupervisors::Call RosSupervisors::MakeAsk(const std::string& subject, const Open& open) {
  return [this, subject, question = open.question, edition = open.edition] {
    coppice_msgs::AskForHelp service;
    service.request.subject = subject;
    service.request.question = question;
    if (!CallService("/assistance/ask", service)) return false;
    OnAsked(subject, edition, service.response.id);
    return true;
  };
}

void RosSupervisors::OnAsked(const std::string& subject, std::uint64_t edition, std::uint32_t id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = open_.find(subject);
  if (found == open_.end() || found->second.edition != edition) return;
  found->second.id = id;
  if (list_ && Find(*list_, id)) Look();
}

// Compares the newest list with what is waited for.
void RosSupervisors::Look() {
  for (auto it = open_.begin(); it != open_.end();) {
    Open& open = it->second;
    const HelpRequest* const request = open.id == 0 ? nullptr : Find(*list_, open.id);
    if (request && request->state != HelpRequest::OPEN) {
      open.done.Send({static_cast<bool>(request->ok), request->message});
      it = open_.erase(it);
      continue;
    }
    if (open.id != 0 && !request) {
      open.id = 0;  // a restarted node does not know it
      changed_.notify_one();
    }
    ++it;
  }
}

}  // namespace coppice::robot::adapters
