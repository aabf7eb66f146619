// Ctrl+C while the main thread runs a tree: the handler of Python only notes the signal for when it
// has its turn again, which is after the tree. So another one comes before it and stops the tree.
#ifndef COPPICE_BT_CORE_PYTHON_INTERRUPT_H_
#define COPPICE_BT_CORE_PYTHON_INTERRUPT_H_

#include <csignal>

#include "bt_core/engine/runner.h"

namespace coppice::python {

class InterruptStops {
 public:
  /// SIGINT and SIGTERM stop the runner, if Python has handlers for them and this is the main
  /// thread. With the GIL. At most one at a time: the main thread runs one tree.
  explicit InterruptStops(Runner& runner);
  ~InterruptStops();
  InterruptStops(const InterruptStops&) = delete;
  InterruptStops& operator=(const InterruptStops&) = delete;

 private:
  bool is_main_;
};

}  // namespace coppice::python

#endif  // COPPICE_BT_CORE_PYTHON_INTERRUPT_H_
