#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tuftwave {

/// The normal equations of a small least-squares problem: a symmetric matrix and a right side.
template <std::size_t size>
struct NormalEquations {
    std::array<std::array<double, size>, size> matrix{};  // only the lower triangle is kept
    std::array<double, size> right{};

    /// Adds one row of the problem: coefficients . unknowns = value.
    void add(const std::array<double, size>& coefficients, double value) {
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = 0; j <= i; ++j) matrix[i][j] += coefficients[i] * coefficients[j];
            right[i] += coefficients[i] * value;
        }
    }

    /// Holds an unknown where it is: its step is zero.
    void hold(std::size_t unknown) {
        for (std::size_t i = 0; i < size; ++i) matrix[i > unknown ? i : unknown][i > unknown ? unknown : i] = 0;
        matrix[unknown][unknown] = 1;
        right[unknown] = 0;
    }

    /// The lower triangle L of matrix = L L^T; nothing where the matrix is not positive definite.
    std::optional<std::array<std::array<double, size>, size>> factor() const {
        auto lower = matrix;
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                double rest = matrix[i][j];
                for (std::size_t m = 0; m < j; ++m) rest -= lower[i][m] * lower[j][m];
                if (i == j && !(rest > 0)) return {};
                lower[i][j] = i == j ? std::sqrt(rest) : rest / lower[j][j];
            }
        }
        return lower;
    }

    /// The unknowns; nothing where they are not determined.
    std::optional<std::array<double, size>> solve() const {
        const auto lower = factor();
        if (!lower) return {};
        std::array<double, size> x = right;
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t m = 0; m < i; ++m) x[i] -= (*lower)[i][m] * x[m];
            x[i] /= (*lower)[i][i];
        }
        for (std::size_t i = size; i-- > 0;) {
            for (std::size_t m = i + 1; m < size; ++m) x[i] -= (*lower)[m][i] * x[m];
            x[i] /= (*lower)[i][i];
        }
        return x;
    }

    /// The variance of an unknown for rows of variance 1; nothing where it is not determined.
    std::optional<double> variance(std::size_t unknown) const {
        NormalEquations unit = *this;
        unit.right = {};
        unit.right[unknown] = 1;
        const auto column = unit.solve();
        return column ? std::optional((*column)[unknown]) : std::nullopt;
    }
};

}  // namespace tuftwave
