#include "bt_core/python/interrupt.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <csignal>

namespace coppice::python {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM};
struct sigaction before[2];
std::atomic<Runner*> stopped_by_signal{nullptr};

int NumberOf(int signal) { return signal == kSignals[0] ? 0 : 1; }

void StopAndPassOn(int signal) {
  if (Runner* const runner = stopped_by_signal) runner->RequestStop();
  const auto handler = before[NumberOf(signal)].sa_handler;
  if (handler != SIG_DFL && handler != SIG_IGN) handler(signal);
}

bool IsMainThread() {
  namespace py = pybind11;
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

// Python's handlers are plain ones; others are left alone.
bool IsHandled(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler != SIG_DFL &&
         action.sa_handler != SIG_IGN;
}

}  // namespace

InterruptStops::InterruptStops(Runner& runner) : is_main_(IsMainThread()) {
  if (!is_main_) return;
  stopped_by_signal = &runner;
  for (const int signal : kSignals) {
    struct sigaction& old = before[NumberOf(signal)];
    sigaction(signal, nullptr, &old);
    if (!IsHandled(old)) continue;
    struct sigaction ours = old;
    ours.sa_handler = &StopAndPassOn;
    sigaction(signal, &ours, nullptr);
  }
}

InterruptStops::~InterruptStops() {
  if (!is_main_) return;
  for (const int signal : kSignals) {
    struct sigaction now;
    sigaction(signal, nullptr, &now);
    const bool is_ours = now.sa_handler == &StopAndPassOn;  // else a leaf has set another one
    if (is_ours) sigaction(signal, &before[NumberOf(signal)], nullptr);
  }
  stopped_by_signal = nullptr;
}

}  // namespace coppice::python
