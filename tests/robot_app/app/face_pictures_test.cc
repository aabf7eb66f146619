#include "robot_app/app/face_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "tests/robot_app/eventually.h"

namespace coppice::robot {
namespace {

class FacePicturesTest : public testing::Test {
 protected:
  // The pictures as they are now.
  const std::map<std::string, LivePicture>& Shown() {
    while (const auto picture = pictures_.pictures()->Next(seen_)) shown_[picture->name] = *picture;
    return shown_;
  }
  bool Shows(const LivePicture& picture) {
    return Eventually([&] {
      const auto at = Shown().find(picture.name);
      return at != Shown().end() && at->second == picture;
    });
  }

  // With bytes behind each row, as a driver may send it.
  static sensor_msgs::Image Image(std::uint32_t width, std::uint32_t height, std::uint8_t red) {
    sensor_msgs::Image image;
    image.width = width;
    image.height = height;
    image.encoding = "rgb8";
    image.step = 3 * width + 1;
    for (std::uint32_t i = 0; i < image.step * height; ++i) {
      image.data.push_back(i % image.step % 3 == 0 ? red : 9);
    }
    return image;
  }

  ros::NodeHandle node_;
  FacePictures pictures_{node_};
  std::uint64_t seen_ = 0;
  std::map<std::string, LivePicture> shown_;
  ros::Publisher images_ = node_.advertise<sensor_msgs::Image>("/face/image", 10, true);
  ros::Publisher names_ = node_.advertise<std_msgs::String>("/face/expression", 10, true);
  ros::Publisher lights_ = node_.advertise<coppice_msgs::Lights>("/face/lights", 10, true);
  ros::Publisher joints_ = node_.advertise<sensor_msgs::JointState>("/joint_states", 10, true);
};

TEST_F(FacePicturesTest, HaveTheFaceWithTheNameOfItsExpression) {
  std_msgs::String name;
  name.data = "SAD";
  names_.publish(name);
  images_.publish(Image(2, 2, 200));
  EXPECT_TRUE(Shows({"face", "SAD", 2, 2, {200, 9, 9, 200, 9, 9, 200, 9, 9, 200, 9, 9}}));
}

TEST_F(FacePicturesTest, WithoutAWidthOrOfMillionsOfPixelsThereIsNoPicture) {
  sensor_msgs::Image image;
  image.encoding = "rgb8";
  image.height = std::numeric_limits<std::uint32_t>::max();
  images_.publish(image);
  image.height = image.width = 5000;
  image.step = 3 * image.width;
  image.data.resize(std::size_t{image.step} * image.height);  // twice this nobody may have
  images_.publish(image);
  images_.publish(Image(1, 1, 200));
  EXPECT_TRUE(Shows({"face", "", 1, 1, {200, 9, 9}}));
}

TEST_F(FacePicturesTest, HaveTheStripsWithTheAnglesOfTheJoints) {
  coppice_msgs::Lights lights;
  lights.ears.g = 1;
  lights.arms.b = 7;  // brighter than there is
  lights_.publish(lights);
  EXPECT_TRUE(Shows({"ears", "", 1, 1, {0, 255, 0}}));
  EXPECT_TRUE(Shows({"arms", "", 1, 1, {0, 0, 255}}));
  sensor_msgs::JointState joints;
  joints.name = {"left_ear_joint", "right_ear_joint", "left_arm_joint", "right_arm_joint"};
  joints.position = {1.5, -0.9, 0};  // one is missing
  joints_.publish(joints);
  EXPECT_TRUE(Shows({"ears", "85° -50°", 1, 1, {0, 255, 0}}));
  EXPECT_EQ(Shown().at("arms").text, "");
}

TEST_F(FacePicturesTest, PassOverMessagesThatAreNoPicture) {
  sensor_msgs::Image image = Image(2, 2, 200);
  image.data.resize(5);
  images_.publish(image);
  image = Image(2, 2, 200);
  image.encoding = "mono8";
  images_.publish(image);
  image = Image(2, 2, 200);
  image.step = 1;
  images_.publish(image);
  images_.publish(Image(100, 100, 200));  // more than watchers take
  images_.publish(Image(0, 0, 200));
  sensor_msgs::JointState joints;
  joints.name = {"left_ear_joint", "right_ear_joint"};
  joints.position = {std::nan(""), 1e300};
  joints_.publish(joints);
  lights_.publish(coppice_msgs::Lights());
  images_.publish(Image(1, 1, 50));
  EXPECT_TRUE(Shows({"face", "", 1, 1, {50, 9, 9}}));
  EXPECT_TRUE(Shows({"ears", "", 1, 1, {0, 0, 0}}));
}

}  // namespace
}  // namespace coppice::robot
