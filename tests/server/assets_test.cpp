#include "assets/assets.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace tuftwave::server {
namespace {

/// A file's bytes, empty where there is none.
std::string bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

TEST(Assets, ContractIsTheFileByteForByte) {
    const std::string text = bytes(TUFTWAVE_SOURCE_DIR "/api/openapi.yaml");
    ASSERT_FALSE(text.empty());
    EXPECT_EQ(asset("openapi.yaml"), text);
}

TEST(Assets, StudioIsAllThatWasBuiltByteForByteOrNothing) {
    const std::filesystem::path built = TUFTWAVE_SOURCE_DIR "/client-examples/studio/dist";
    EXPECT_EQ(asset("studio/index.html").has_value(), exists(built / "index.html"));
    if (!exists(built / "index.html")) return;
    for (const auto& entry : std::filesystem::directory_iterator(built)) {
        const std::string name = entry.path().filename();
        EXPECT_TRUE(asset("studio/" + name) == bytes(entry.path())) << name << " is not the one that was built in";
    }
}

TEST(Assets, UnknownNameIsNothing) {
    for (const char* name : {"", "openapi", "../openapi.yaml", "api/openapi.yaml"}) EXPECT_FALSE(asset(name)) << name;
}

}  // namespace
}  // namespace tuftwave::server
