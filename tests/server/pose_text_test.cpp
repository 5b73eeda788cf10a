#include "api/pose_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

TEST(PoseText, PutsPosesInThePlaceOfPictures) {
    const Json frame{{"name", "\"pictures\":null"}, {"pictures", nullptr}, {"z", 1}};
    const NodePose a = node_pose({0, 0.5, 0, 1}, {0, 0, 0, 1}, {0.1, 1, -2}), b = node_pose({}, {}, {});
    const std::vector<ChainPoses> chains{{"x\"", 1, {a, b}}, {"y", 1, {b, a}}};
    const std::string at_rest =
        R"("rotations":[[0.0,0.0,0.0,1.0]],"turns":[[0.0,0.0,0.0,1.0]],"positions":[[0.0,0.0,0.0]]})";
    const std::string turned =
        R"("rotations":[[0.0,0.5,0.0,1.0]],"turns":[[0.0,0.0,0.0,1.0]],"positions":[[0.1,1.0,-2.0]]})";
    EXPECT_EQ(text_with_poses(frame.dump(), chains, 2),
              R"({"name":"\"pictures\":null","pictures":[{"chains":[{"name":"x\"",)" + turned + R"(,{"name":"y",)" +
                  at_rest + R"(]},{"chains":[{"name":"x\"",)" + at_rest + R"(,{"name":"y",)" + turned +
                  R"(]}],"z":1})");
}

TEST(PoseText, TellsWhereEveryNodeIs) {
    Chain chain;
    chain.name = "c";
    chain.nodes = {{0, 1, 0}, {0, 0, 0}};
    chain.rest_rotations = {{}, {}};
    HairMotion motion;
    motion.schedule.pictures = 2;
    motion.chains = {{0, {{}, {}, {0, 0, 1, 0}, {}}}};
    const auto poses = chain_poses(std::span(&chain, 1), motion, {});
    ASSERT_EQ(poses.size(), 1U);
    ASSERT_EQ(poses[0].poses.size(), 4U);
    EXPECT_EQ(poses[0].poses[1].position, (std::array{0.F, 0.F, 0.F}));
    EXPECT_EQ(poses[0].poses[3].position, (std::array{0.F, 2.F, 0.F}));
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_TRUE(chain_poses(std::span(&chain, 1), motion, stopped.get_token())[0].poses.empty());
}

}  // namespace
}  // namespace tuftwave::server
