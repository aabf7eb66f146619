// What the monitor tree may ask of the application tree, and what that tells in return. Each
// function is called on the ticking thread of one of the two trees and returns at once.
#ifndef COPPICE_BT_NODES_APPLICATION_APPLICATION_CONTROL_H_
#define COPPICE_BT_NODES_APPLICATION_APPLICATION_CONTROL_H_

namespace coppice::leaves {

class ApplicationControl {
 public:
  virtual ~ApplicationControl() = default;
  /// To the application: the robot must (or need no longer) go and charge.
  virtual void SetChargeRequested(bool requested) = 0;
  /// From the application: it is (or is no longer) on its way to the station, or charges there.
  virtual void SetGoingHome(bool going_home) = 0;
  /// Halts the application; it does nothing until it is resumed, and then begins anew.
  virtual void Suspend() = 0;
  virtual void Resume() = 0;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_APPLICATION_APPLICATION_CONTROL_H_
