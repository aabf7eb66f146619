#include "robot_app/storage/server/shipper.h"

#include <pthread.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace coppice::robot::storage {
namespace {

using Answer = StoreResult::Answer;

std::int64_t Now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

Batch Alone(const Batch& batch, const Document& document) {
  return {batch.robot, batch.spool, {document}, batch.losses};
}

// The server has refused the batch: each by itself. False if it does not answer any more.
bool ShipOneByOne(Spool& spool, DocumentServer& server, const Batch& batch, ShipperState& state) {
  for (const Document& document : batch.documents) {
    const Batch one = Alone(batch, document);
    const StoreResult result = server.Store(one);
    state.problem = result.answer == Answer::kAway ? result.problem : "";
    if (result.answer == Answer::kAway) return false;
    if (result.answer == Answer::kRefused) {
      spool.SetAside(one, result.problem);
    } else {
      spool.Remove(one);
      ++state.sent;
    }
  }
  return true;
}

}  // namespace

bool ShipNext(Spool& spool, DocumentServer& server, const ShipperOptions& options,
              ShipperState& state) {
  Batch batch = spool.Next(options.batch);
  if (batch.documents.empty()) return false;
  batch.robot = options.robot;
  const StoreResult result = server.Store(batch);
  if (result.answer == Answer::kRefused) return ShipOneByOne(spool, server, batch, state);
  state.problem = result.problem;
  if (result.answer == Answer::kAway) return false;
  spool.Remove(batch);
  state.sent += batch.documents.size();
  return true;
}

Shipper::Shipper(Spool& spool, DocumentServer& server, ShipperOptions options)
    : spool_(spool),
      server_(server),
      options_(std::move(options)),
      pause_(options_.first_pause),
      thread_([this] { Run(); }) {}

Shipper::~Shipper() {
  is_ending_ = true;
  wake_up_.Notify();
  do {
    server_.Abort();  // again: the server may have been asked just now
  } while (!has_ended_.WaitFor(std::chrono::milliseconds(100)));
  thread_.join();
}

void Shipper::Watch() {
  const std::int64_t asked_at = asked_at_;
  if (asked_at != 0 && Now() - asked_at > options_.patience.count()) server_.Abort();
}

ShipperState Shipper::Look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

// A spool that cannot be written any more keeps what was sent already; it is sent again.
bool Shipper::Step(ShipperState& state) {
  asked_at_ = Now();
  bool is_more = false;
  try {
    is_more = ShipNext(spool_, server_, options_, state);
  } catch (const std::runtime_error& error) {
    state.problem = error.what();
  }
  asked_at_ = 0;
  return is_more;
}

Duration Shipper::PauseAfter(const ShipperState& state, bool is_more) {
  if (is_more) return Duration::zero();
  if (state.problem.empty()) {
    pause_ = options_.first_pause;
    return pause_;
  }
  return std::exchange(pause_, std::min(2 * pause_, options_.longest_pause));
}

void Shipper::Run() {
  pthread_setname_np(pthread_self(), "store_shipper");
  ShipperState state;
  while (!is_ending_) {
    const bool is_more = Step(state);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      state_ = state;
    }
    const Duration pause = PauseAfter(state, is_more);
    const auto until = std::chrono::steady_clock::now() + pause;
    // New documents end a pause for want of documents, not one for want of a server.
    while (!is_ending_ && std::chrono::steady_clock::now() < until) {
      if (wake_up_.WaitFor(until - std::chrono::steady_clock::now()) && state.problem.empty())
        break;
    }
  }
  has_ended_.Notify();
}

}  // namespace coppice::robot::storage
