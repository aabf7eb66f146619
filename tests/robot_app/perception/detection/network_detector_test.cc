#include "robot_app/perception/detection/network_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "bt_core/model/write_file.h"
#include "tests/robot_app/perception/detection/tiny_onnx.h"

namespace coppice::robot::perception {
namespace {

// A network of Darknet with one layer that sees somebody in the cells that are red.
constexpr char kConfig[] =
    "[net]\nwidth=64\nheight=64\nchannels=3\n\n"
    "[convolutional]\nfilters=6\nsize=1\nstride=32\npad=0\nactivation=linear\n\n"
    "[yolo]\nmask=0\nanchors=16,32\nclasses=1\nnum=1\n";

class Network : public testing::Test {
 protected:
  static void Write(const std::string& file, const std::string& bytes) {
    Diagnostics diagnostics;
    ASSERT_TRUE(WriteFile(file, bytes, diagnostics)) << diagnostics.ToString();
  }

  void SetUp() override {
    files_.file = testing::TempDir() + "red.weights";
    files_.config = testing::TempDir() + "red.cfg";
    Write(files_.config, kConfig);
    Write(files_.file, Weights());
  }

  // The version, how many pictures it has seen, six offsets, six weights for each colour.
  static std::string Weights() {
    const std::array<std::int32_t, 3> version{0, 2, 0};
    const std::int64_t seen = 0;
    std::array<float, 6 + 6 * 3> numbers{};
    numbers[4] = -10;         // somebody there: at more than half of red
    numbers[5] = 10;          // always of the one class
    numbers[6 + 4 * 3] = 20;  // the weight of red for "somebody there"
    std::string bytes(reinterpret_cast<const char*>(version.data()), sizeof(version));
    bytes.append(reinterpret_cast<const char*>(&seen), sizeof(seen));
    return bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
  }

  std::string ProblemOf() const {
    const auto detector = MakeNetworkDetector(files_, 0.5);
    return detector ? "" : detector.problem();
  }

  NetworkFiles files_;
};

TEST_F(Network, OfDarknetSeesWhatItHasLearntWhereItIs) {
  const auto detector = MakeNetworkDetector(files_, 0.5);
  ASSERT_TRUE(detector) << detector.problem();
  Picture picture(128, 64);  // half as high as wide: the network sees gray above and below
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {  // blue, and red on the right
    picture.rgb[i / 3 % 128 < 64 ? i + 2 : i] = 255;
  }
  const auto seen = (*detector)->Find(picture);
  ASSERT_FALSE(seen.empty());
  for (const Sighting& sighting : seen) {
    EXPECT_EQ(sighting.kind, SightingKind::kPerson);
    EXPECT_NEAR(sighting.box.x + sighting.box.width / 2, 96, 1);
    EXPECT_NEAR(sighting.box.width, 32, 1);
    EXPECT_NEAR(sighting.box.height, 64, 1);
  }
}

TEST_F(Network, SeesNothingInTheDarkAndNothingInNoPicture) {
  const auto detector = MakeNetworkDetector(files_, 0.5);
  ASSERT_TRUE(detector) << detector.problem();
  EXPECT_TRUE((*detector)->Find(Picture(64, 64)).empty());
  EXPECT_TRUE((*detector)->Find(Picture()).empty());
}

TEST_F(Network, WithoutItsFilesIsAProblemThatNamesThem) {
  files_.config.clear();
  EXPECT_NE(ProblemOf().find(".cfg"), std::string::npos) << ProblemOf();
  files_.config = "/nowhere.cfg";
  EXPECT_NE(ProblemOf().find("/nowhere.cfg"), std::string::npos) << ProblemOf();
  files_.file = "/nowhere.onnx";
  EXPECT_NE(ProblemOf().find("/nowhere.onnx"), std::string::npos) << ProblemOf();
  files_.file = "/nowhere.pt";
  EXPECT_NE(ProblemOf().find(".weights or .onnx"), std::string::npos) << ProblemOf();
}

TEST_F(Network, OfDamagedFilesIsAProblem) {
  Write(files_.config, "[net]\nwidth=64\nheight=64\nchannels=3\n\n[yolo]\n");
  EXPECT_NE(ProblemOf().find("red.weights"), std::string::npos) << ProblemOf();
  files_.file = testing::TempDir() + "damaged.onnx";
  Write(files_.file, "this is no network");
  EXPECT_NE(ProblemOf().find("damaged.onnx"), std::string::npos) << ProblemOf();
}

TEST_F(Network, ForPicturesOfNoSizeOrAHugeOneIsAProblem) {
  for (const char* const size : {"0", "-1", "99999"}) {
    Write(files_.config, std::string("[net]\nwidth=") + size + std::string(kConfig).substr(14));
    EXPECT_NE(ProblemOf(), "") << size;
  }
}

TEST_F(Network, OfAnotherNumberOfClassesThanNamedIsAProblem) {
  files_.classes = testing::TempDir() + "three.names";
  Write(files_.classes, "person\ncat\ndog\n");
  EXPECT_NE(ProblemOf().find("names 3 classes, and the network has 1"), std::string::npos)
      << ProblemOf();
}

// OpenCV divides by these numbers, or looks for layers where there are none.
TEST_F(Network, AtWhichOpenCvCrashesIsAProblem) {
  const std::string net = "[net]\nwidth=64\nheight=64\nchannels=3\n\n";
  for (const std::string layer :
       {"[convolutional]\nfilters=6\nsize=0\nstride=0\npad=0\n", "[maxpool]\nsize=0\nstride=0\n",
        "[reorg]\nstride=0\n", "[upsample]\nstride=0\n", "[route]\nlayers=-70\n",
        "[shortcut]\nfrom=-70\n", "[convolutional]\ngroups=0\nfilters=6\nsize=1\nstride=1\n",
        "[yolo]\nmask=0,9,99\nanchors=16\nclasses=-1\nnum=0\n"}) {
    Write(files_.config, net + layer);
    EXPECT_NE(ProblemOf().find("red.weights: OpenCV cannot run it"), std::string::npos)
        << layer << ProblemOf();
  }
}

class OnnxNetwork : public Network, public testing::WithParamInterface<bool> {
 protected:
  void SetUp() override {
    files_ = {testing::TempDir() + (GetParam() ? "rows.onnx" : "columns.onnx"), "", "",
              kTinySquare};
    Write(files_.file, TinyOnnx(GetParam()));
  }
};

TEST_P(OnnxNetwork, SeesWhatIsThereWhereItIs) {
  const auto detector = MakeNetworkDetector(files_, 0.5);
  ASSERT_TRUE(detector) << detector.problem();
  EXPECT_TRUE((*detector)->Finds(SightingKind::kPerson));
  EXPECT_FALSE((*detector)->Finds(SightingKind::kFace));
  Picture picture(kTinySquare, kTinySquare);
  for (int row = kTinyCell; row < 2 * kTinyCell; ++row) {
    for (int column = 2 * kTinyCell; column < 3 * kTinyCell; ++column) {
      picture.rgb[3 * (static_cast<std::size_t>(row) * kTinySquare + column)] = 255;
    }
  }
  const auto seen = (*detector)->Find(picture);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].kind, SightingKind::kPerson);
  EXPECT_NEAR(seen[0].box.x, 2 * kTinyCell, 0.1);
  EXPECT_NEAR(seen[0].box.y, kTinyCell, 0.1);
  EXPECT_NEAR(seen[0].box.width, kTinyCell, 0.1);
  EXPECT_NEAR(seen[0].confidence, 1, 0.01);
}

TEST_P(OnnxNetwork, CutOffAnywhereIsAProblemOrANetworkButNoCrash) {
  const std::string whole = TinyOnnx(GetParam());
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
    Write(files_.file, whole.substr(0, size));
    if (auto detector = MakeNetworkDetector(files_, 0.5)) {
      (*detector)->Find(Picture(64, 64));
    } else {
      EXPECT_NE(detector.problem().find(files_.file), std::string::npos) << detector.problem();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfBothLayouts, OnnxNetwork, testing::Bool());

}  // namespace
}  // namespace coppice::robot::perception
