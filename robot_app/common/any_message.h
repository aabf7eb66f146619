// A message of any type whose content is not read: for counting what comes on a topic.
#ifndef COPPICE_ROBOT_APP_COMMON_ANY_MESSAGE_H_
#define COPPICE_ROBOT_APP_COMMON_ANY_MESSAGE_H_

#include <ros/message_traits.h>
#include <ros/serialization.h>

namespace coppice::robot {

/// Subscribe to it with a ros::NodeHandle; it fits every publisher. Cannot be published.
struct AnyMessage {};

}  // namespace coppice::robot

namespace ros {
namespace message_traits {

template <>
struct IsMessage<coppice::robot::AnyMessage> : TrueType {};
template <>
struct IsMessage<const coppice::robot::AnyMessage> : TrueType {};

template <>
struct MD5Sum<coppice::robot::AnyMessage> {
  static const char* value() { return "*"; }
  static const char* value(const coppice::robot::AnyMessage&) { return "*"; }
};

template <>
struct DataType<coppice::robot::AnyMessage> {
  static const char* value() { return "*"; }
  static const char* value(const coppice::robot::AnyMessage&) { return "*"; }
};

template <>
struct Definition<coppice::robot::AnyMessage> {
  static const char* value() { return ""; }
  static const char* value(const coppice::robot::AnyMessage&) { return ""; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<coppice::robot::AnyMessage> {
  template <typename Stream>
  static void read(Stream&, coppice::robot::AnyMessage&) {}
};

}  // namespace serialization
}  // namespace ros

#endif  // COPPICE_ROBOT_APP_COMMON_ANY_MESSAGE_H_
