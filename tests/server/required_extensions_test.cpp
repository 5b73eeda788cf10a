#include "character/required_extensions.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server::character {
namespace {

std::optional<Fault> fault_of(const FileJson& required) {
    std::optional<Fault> fault;
    check_required_extensions({&required, "/extensionsRequired", fault});
    return fault;
}

TEST(RequiredExtensions, OfMaterialsAndAvatarsAreTaken) {
    EXPECT_FALSE(fault_of({"VRM", "VRMC_vrm", "VRMC_springBone", "VRMC_materials_mtoon", "KHR_materials_unlit",
                           "KHR_texture_transform", "KHR_mesh_quantization"}));
    EXPECT_FALSE(fault_of(FileJson::array()));
}

TEST(RequiredExtensions, ThatChangeWhatIsReadAreNamed) {
    for (const char* const name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing",
                                   "KHR_materials", "VRMC_vrm2", "vrm", ""}) {
        const auto fault = fault_of({"VRM", name});
        ASSERT_TRUE(fault) << name;
        EXPECT_EQ(fault->kind, Fault::Kind::kUnsupported) << name;
        EXPECT_EQ(fault->pointer, "/extensionsRequired/1") << name;
        EXPECT_EQ(std::get<std::string>(fault->given), name);
    }
}

TEST(RequiredExtensions, AreAListOfText) {
    EXPECT_EQ(fault_of(FileJson::object())->kind, Fault::Kind::kWrongType);
    const auto fault = fault_of({"VRM", 3});
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, Fault::Kind::kWrongType);
    EXPECT_EQ(fault->pointer, "/extensionsRequired/1");
}

}  // namespace
}  // namespace tuftwave::server::character
