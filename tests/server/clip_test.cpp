#include "character/clip.hpp"

#include "character_samples.hpp"
#include "gltf/clip_keys.hpp"

namespace tuftwave::server::character {
namespace {

constexpr gltf::Holding kAllHoldings[] = {gltf::Holding::kStep, gltf::Holding::kHeld, gltf::Holding::kPerFrame};

Schedule eleven_frames() { return *make_schedule({}, Formulas::kCorrected, {}); }

/// A turn about z for each picture: easy to tell apart.
NodeKeys keys_of(int node, const Schedule& schedule) {
    NodeKeys keys{node, {}};
    for (int n = 0; n < schedule.pictures; ++n) keys.rotations.push_back(turn_about({0, 0, 1}, 0.1 * (n + 1)));
    return keys;
}

std::vector<float> floats(const std::string& bytes) {
    std::vector<float> numbers(bytes.size() / sizeof(float));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

TEST(Clip, WritesTimesAndThenEachNodesKeys) {
    for (const gltf::Holding holding : kAllHoldings) {
        Sample sample;
        const int a = sample.add_node("a"), b = sample.add_node("b", a);
        const Character character = read(sample);
        const Schedule schedule = eleven_frames();
        const gltf::ClipKeys keys = gltf::clip_keys(schedule, holding);
        const std::string added = add_held_clip(sample.json, character, {keys_of(a, schedule), keys_of(b, schedule)},
                                                keys, "wave", FileJson::object(), 0);
        const std::vector<float> numbers = floats(added);
        ASSERT_EQ(numbers.size(), keys.times.size() * 9);
        for (std::size_t k = 0; k < keys.times.size(); ++k) {
            EXPECT_EQ(numbers[k], keys.times[k]);
            const Quat expected = turn_about({0, 0, 1}, 0.1 * static_cast<double>(keys.pictures[k] + 1));
            for (const std::size_t node : {0U, 1U}) {
                const std::size_t at = keys.times.size() * (1 + 4 * node) + 4 * k;
                EXPECT_EQ(numbers[at + 2], static_cast<float>(expected.z));
                EXPECT_EQ(numbers[at + 3], static_cast<float>(expected.w));
            }
        }
        const FileJson& animation = sample.json["animations"][0];
        EXPECT_EQ(animation["samplers"][1]["interpolation"], keys.is_stepped ? "STEP" : "LINEAR");
        EXPECT_EQ(animation["channels"][1]["target"]["node"], b);
        EXPECT_EQ(sample.json["buffers"][0]["byteLength"], added.size());
    }
}

TEST(Clip, ComesBehindAllThatIsThere) {
    Sample sample;
    const int node = sample.add_node("a");
    const std::string there(20, 'x');
    sample.add_accessor(there, kUnsignedByte, "SCALAR", there.size());
    sample.add("buffers", {{"byteLength", 18}, {"name", "mine"}});
    sample.add("animations", {{"name", "walk"}});
    const FileJson before = sample.json;
    const Schedule schedule = eleven_frames();
    const std::string added =
        add_held_clip(sample.json, read(sample), {keys_of(node, schedule)},
                      gltf::clip_keys(schedule, gltf::Holding::kStep), "wave", {{"fps", 24}}, there.size());
    EXPECT_EQ(sample.json["accessors"][0], before["accessors"][0]);
    EXPECT_EQ(sample.json["bufferViews"][0], before["bufferViews"][0]);
    EXPECT_EQ(sample.json["animations"][0], before["animations"][0]);
    EXPECT_EQ(sample.json["nodes"], before["nodes"]);
    EXPECT_EQ(sample.json["bufferViews"][1]["byteOffset"], there.size());
    EXPECT_EQ(
        sample.json["buffers"],
        FileJson::parse("[{\"byteLength\": " + std::to_string(there.size() + added.size()) + ", \"name\": \"mine\"}]"));
    EXPECT_EQ(sample.json["animations"][1]["extras"]["fps"], 24);
}

TEST(Clip, TakesTheMatrixOfAMovedNodeApart) {
    Sample sample;
    const int moved = sample.add_node("a"), still = sample.add_node("b");
    for (const int node : {moved, still})
        sample.node(node) =
            FileJson::parse(R"({"matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1], "name": "n"})");
    const Schedule schedule = eleven_frames();
    add_held_clip(sample.json, read(sample), {keys_of(moved, schedule)},
                  gltf::clip_keys(schedule, gltf::Holding::kStep), "wave", FileJson::object(), 0);
    EXPECT_TRUE(sample.node(still).contains("matrix"));
    const FileJson& node = sample.node(moved);
    EXPECT_FALSE(node.contains("matrix"));
    EXPECT_EQ(node["translation"], (FileJson{1.0, 2.0, 3.0}));
    EXPECT_NEAR(node["scale"][1].get<double>(), 2, 1e-12);
    EXPECT_NEAR(std::abs(node["rotation"][2].get<double>()), std::sqrt(0.5), 1e-12);
}

TEST(Clip, DoesNotFitWhereItsNameIsTakenOrTheBufferIsElsewhere) {
    Sample sample;
    EXPECT_FALSE(check_clip_fits(sample.json, "wave", 0));
    sample.add("animations", {{"name", "wave"}});
    EXPECT_EQ(check_clip_fits(sample.json, "wave", 0)->pointer, "/animations/0/name");
    EXPECT_FALSE(check_clip_fits(sample.json, "wave2", 0));
    sample.add("buffers", {{"byteLength", 8}, {"uri", "hair.bin"}});
    EXPECT_EQ(check_clip_fits(sample.json, "wave2", 8)->pointer, "/buffers/0/uri");
    sample.json["buffers"][0].erase("uri");
    EXPECT_FALSE(check_clip_fits(sample.json, "wave2", 8));
    EXPECT_EQ(check_clip_fits(sample.json, "wave2", 4)->pointer, "/buffers/0/byteLength");
    sample.json["accessors"] = 3;
    EXPECT_EQ(check_clip_fits(sample.json, "wave2", 8)->pointer, "/accessors");
}

}  // namespace
}  // namespace tuftwave::server::character
