// Based on: K. Furukawa, S. Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime
// Production. ICEC 2018. Equation (1).
#include <cmath>

#include "hair.hpp"

namespace afternoon {
namespace {

constexpr double kPi = 3.14159265358979;
constexpr double kAmplitude = 0.8, kSpatialPeriod = 1.0, kLightness = 1.2;  // a, k, s, as the service has them

double height(double x, double phase) {
    return -kAmplitude / kLightness * (x / kPi) * (std::cos(x / kSpatialPeriod - phase) + 1 / kLightness);  // eq. (1)
}

/// The chords' angles: picture n, bone i at [n][i].
std::vector<std::vector<double>> angles_of(const Points& chain, int pictures) {
    std::vector<double> x{0};
    for (std::size_t i = 1; i < chain.size(); ++i)
        x.push_back(x.back() + static_cast<double>(glm::length(chain[i] - chain[i - 1])));
    const double whole = x.back();
    for (double& place : x) place *= kPi / whole;
    std::vector<std::vector<double>> angles;
    for (int n = 0; n < pictures; ++n) {
        const double phase = 2 * kPi * n / pictures;
        angles.emplace_back();
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            angles.back().push_back(std::atan2(height(x[i + 1], phase) - height(x[i], phase), x[i + 1] - x[i]));
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        double mean = 0;
        for (const auto& picture : angles) mean += picture[i] / pictures;
        for (auto& picture : angles) picture[i] -= mean;
    }
    return angles;
}

}  // namespace

Poses move(const std::vector<Points>& chains, int pictures) {
    const glm::vec3 axis(0, 0, 1);  // the wind blows along +X, up is +Y
    Poses poses(static_cast<std::size_t>(pictures));
    for (const Points& chain : chains) {
        const auto angles = angles_of(chain, pictures);
        for (std::size_t n = 0; n < poses.size(); ++n) {
            std::vector<glm::quat> rotations;
            glm::quat parent(1, 0, 0, 0);
            for (const double angle : angles[n]) {
                const glm::quat global = glm::angleAxis(static_cast<float>(angle), axis);
                rotations.push_back(glm::normalize(glm::inverse(parent) * global));
                parent = global;
            }
            poses[n].push_back(rotations);
        }
    }
    return poses;
}

}  // namespace afternoon
