// Ctrl+C for verbs that go on until somebody ends them.
#ifndef COPPICE_BT_CORE_CLI_LIVE_INTERRUPT_H_
#define COPPICE_BT_CORE_CLI_LIVE_INTERRUPT_H_

#include <csignal>

namespace coppice {

/// While it lives, SIGINT and SIGTERM end nothing: they are remembered. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool came() const;

 private:
  struct sigaction before_int_;
  struct sigaction before_term_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_INTERRUPT_H_
