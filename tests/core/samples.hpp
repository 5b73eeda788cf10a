#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tuftwave/head.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/tuft.hpp"

/// Hair that people really draw, and strokes that only an unlucky hand draws, on a head of 10 cm radius at the origin.
namespace tuftwave::test {

inline Tuft tuft_along(std::string name, std::vector<Vec3> points) {
    Tuft tuft;
    tuft.name = std::move(name);
    tuft.points = std::move(points);
    return tuft;
}

/// Over the forehead, down to the eyes.
inline Tuft fringe() {
    Tuft tuft =
        tuft_along("fringe", {{0.02, 0.09, 0.05}, {0.025, 0.07, 0.09}, {0.03, 0.03, 0.11}, {0.03, -0.02, 0.11}});
    tuft.section = Section::kEllipse;
    tuft.flatness = 0.6;
    return tuft;
}

/// Thick, from the back of the head down.
inline Tuft ponytail() {
    Tuft tuft = tuft_along("ponytail",
                           {{0, 0.06, -0.08}, {0, 0.07, -0.14}, {0, 0, -0.18}, {0.01, -0.15, -0.17}, {0, -0.3, -0.15}});
    tuft.diameter = 70;
    tuft.joints = 8;
    return tuft;
}

/// One of the two at the sides; the other is its mirror image.
inline Tuft twin_tail(const double side) {
    Tuft tuft = tuft_along(
        side > 0 ? "twin left" : "twin right",
        {{side * 0.08, 0.06, 0}, {side * 0.15, 0.08, 0}, {side * 0.2, -0.05, 0.01}, {side * 0.18, -0.25, 0.02}});
    tuft.widest_at = 60;
    tuft.taper = Taper::kSmooth;
    return tuft;
}

/// The single hair that stands up, one bone long.
inline Tuft ahoge() {
    Tuft tuft = tuft_along("ahoge", {{0, 0.1, 0}, {0.02, 0.16, 0.01}, {0.06, 0.17, 0.02}});
    tuft.diameter = 8;
    tuft.joints = 1;
    tuft.taper = Taper::kLinear;
    return tuft;
}

/// A helix of three turns. @param radius  of the helix, metres
inline Tuft ringlet(const double radius) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 36; ++i) {
        const double turn = i * kPi / 6;
        points.push_back({0.1 + radius * std::cos(turn), 0.02 - 0.005 * i, radius * std::sin(turn)});
    }
    return tuft_along("ringlet", points);
}

/// Out and back, 1 cm apart.
inline Tuft hairpin() {
    return tuft_along("hairpin", {{0, 0.1, 0}, {0.1, 0.1, 0}, {0.15, 0.105, 0}, {0.1, 0.11, 0}, {0, 0.11, 0}});
}

/// Sharp corners, nearer to each other than the tuft is wide.
inline Tuft zigzag() {
    std::vector<Vec3> points;
    for (int i = 0; i < 10; ++i) points.push_back({i % 2 == 0 ? 0.1 : 0.14, 0.05 - 0.01 * i, 0});
    return tuft_along("zigzag", points);
}

/// Out and back on exactly the same line.
inline Tuft there_and_back() { return tuft_along("there and back", {{0, 0.1, 0}, {0, 0.2, 0}, {0, 0.1, 0}}); }

/// Tufts whose bends are wider than they are thick.
inline std::vector<Tuft> smooth_tufts() { return {fringe(), ponytail(), twin_tail(1), twin_tail(-1), ahoge()}; }

/// Tufts that bend more tightly than they are thick.
inline std::vector<Tuft> tight_tufts() { return {ringlet(0.01), hairpin(), zigzag(), there_and_back()}; }

inline std::vector<Tuft> all_tufts() {
    std::vector<Tuft> tufts = smooth_tufts();
    for (Tuft& tuft : tight_tufts()) tufts.push_back(std::move(tuft));
    return tufts;
}

}  // namespace tuftwave::test
