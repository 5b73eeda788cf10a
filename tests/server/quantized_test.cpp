#include "gltf/quantized.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace tuftwave::server::gltf {
namespace {

using Component = Document::Component;
using Purpose = Document::Purpose;
using Shape = Document::Shape;

constexpr std::size_t kVertices = 20'000;  // more than one job has

/// Vertices on a slope, two to four metres away; with a skin of one joint, or without.
class Slope {
  public:
    explicit Slope(std::size_t joints) {
        const auto attribute = [&](std::size_t stride, Component component, Shape shape, bool is_bounded = false) {
            const int view = document_.add_view(Purpose::kAttribute, kVertices * stride, stride);
            return document_.add_accessor({view, 0, kVertices, component, shape, is_bounded});
        };
        positions_ = attribute(12, Component::kF32, Shape::kVec3, true);
        const int normals = attribute(12, Component::kF32, Shape::kVec3);
        const int uvs = attribute(8, Component::kF32, Shape::kVec2);
        std::optional<int> bones, weights, matrices, skin;
        if (joints > 0) {
            bones = attribute(8, Component::kU16, Shape::kVec4);
            weights = attribute(16, Component::kF32, Shape::kVec4);
            matrices =
                document_.add_accessor({document_.add_view(Purpose::kData, 64), 0, 1, Component::kF32, Shape::kMat4});
        }
        const int indices =
            document_.add_accessor({document_.add_view(Purpose::kIndex, 12), 0, 3, Component::kU32, Shape::kScalar});
        const int mesh = document_.add_mesh("slope", {positions_, normals, uvs, bones, weights, indices, 0});
        if (joints > 0) skin = document_.add_skin(std::vector<int>(joints, 0), *matrices, 0);
        document_.set_node_extras(document_.add_node({"slope", {}, {}, mesh, skin}), {{"kept", true}});
        document_.allocate(Container::kGlb);
        for (const int accessor : {positions_, normals, uvs, indices})
            std::ranges::fill(document_.bytes(accessor), std::byte{});
        for (std::size_t i = 0; i < kVertices; ++i) {
            const float share = static_cast<float>(i) / (kVertices - 1);
            const std::array<float, 3> at{2 + 2 * share, -share, 0.5F};
            std::ranges::copy(at, document_.data<float>(positions_).begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
        document_.set_bounds(positions_, bounds_of(document_.data<float>(positions_)));
        if (joints == 0) return;
        std::ranges::fill(document_.bytes(*bones), std::byte{});
        std::ranges::fill(document_.data<float>(*weights), 0.25F);
        // A quarter turn about z, and a move.
        const std::array<float, 16> matrix{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1};
        std::ranges::copy(matrix, document_.data<float>(*matrices).begin());
        matrices_ = *matrices;
    }

    Document::Model& model() { return document_.model(); }
    std::string members() { return std::string(model().text(model().nodes[0].members)); }  ///< of its node
    std::array<float, 3> position(std::size_t i) {
        const auto all = document_.data<float>(positions_);
        return {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
    }
    std::array<float, 16> matrix() {
        std::array<float, 16> copy{};
        std::ranges::copy(document_.data<float>(matrices_), copy.begin());
        return copy;
    }

  private:
    Document document_{"test"};
    int positions_, matrices_ = 0;
};

TEST(Quantized, ANodeCarriesPositionsBack) {
    Slope slope(0);
    const Quantized made = quantize(slope.model(), InOrder(), {});
    ASSERT_EQ(made.views[0].size(), 8 * kVertices);
    EXPECT_EQ(made.views[1].size(), 4 * kVertices);
    EXPECT_EQ(made.views[2].size(), 4 * kVertices);
    const nlohmann::json node = nlohmann::json::parse("{" + slope.members() + "}");
    EXPECT_EQ(node["scale"], nlohmann::json({2.0, 2.0, 2.0}));
    EXPECT_EQ(node["translation"], nlohmann::json({2.0, -1.0, 0.5}));
    EXPECT_EQ(slope.model().text(slope.model().nodes[0].extras), R"({"kept":true})");
    const auto* const packed = reinterpret_cast<const std::uint16_t*>(made.views[0].data());
    for (std::size_t i = 0; i < kVertices; ++i) {
        const std::array<float, 3> plain = slope.position(i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double origin = node["translation"][axis];
            ASSERT_NEAR(origin + 2 * (packed[4 * i + axis] / 65'535.0), static_cast<double>(plain[axis]), 1.6e-5) << i;
        }
    }
    const Document::Accessor& positions = slope.model().accessors[0];
    EXPECT_EQ(positions.component, Component::kU16);
    EXPECT_TRUE(positions.is_normalized);
    EXPECT_EQ(slope.model().bounds[0].box.least, (std::array<float, 3>{0, 0, 0}));
    EXPECT_EQ(slope.model().bounds[0].box.most, (std::array<float, 3>{65'535, 32'768, 0}));
}

TEST(Quantized, ASkinCarriesPositionsBackAndItsNodeStaysWhereItIs) {
    Slope slope(1);
    const std::array<float, 16> before = slope.matrix();
    const Quantized made = quantize(slope.model(), InOrder(), {});
    EXPECT_EQ(slope.members(), R"("mesh":0,"name":"slope","skin":0)");
    const std::array<float, 16> after = slope.matrix();
    const auto* const packed = reinterpret_cast<const std::uint16_t*>(made.views[0].data());
    for (const std::size_t i : {std::size_t{0}, kVertices / 3, kVertices - 1}) {
        const std::array<float, 3> plain = slope.position(i);
        for (std::size_t row = 0; row < 3; ++row) {
            double is = after[12 + row], was = before[12 + row];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                is += static_cast<double>(after[4 * axis + row]) * packed[4 * i + axis] / 65'535;
                was += static_cast<double>(before[4 * axis + row]) * static_cast<double>(plain[axis]);
            }
            EXPECT_NEAR(is, was, 2e-5) << i;
        }
    }
    EXPECT_EQ(made.views[4].size(), 4 * kVertices);  // weights
    EXPECT_EQ(slope.model().accessors[3].component, Component::kU8);
}

TEST(Quantized, JointsThatAByteCannotTellApartStayWide) {
    for (const auto& [joints, component] : {std::pair{256u, Component::kU8}, std::pair{257u, Component::kU16}}) {
        Slope slope(joints);
        const Quantized made = quantize(slope.model(), InOrder(), {});
        EXPECT_EQ(slope.model().accessors[3].component, component);
        EXPECT_EQ(made.views[3].size(), kVertices * (component == Component::kU8 ? 4 : 8));
        EXPECT_FALSE(slope.model().accessors[3].is_normalized);
    }
}

}  // namespace
}  // namespace tuftwave::server::gltf
