#include "ui/views/stroke_tiles.hpp"

#include "ui/views/device_pixels.hpp"

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace echotrail {
namespace {

/// Pixels are worked on in squares of this side: what is between the lines of a large shape costs nothing.
constexpr int tile_px = 32;
constexpr float nearest = 255.0F;  ///< on the middle of a line
constexpr float least_slope = 1e-4F;

/// How near a pixel lies to a line, as it is kept: 0 is as far as ink reaches, or farther.
struct Nearness {
    float line_half = 0.5F;
    float reach = 1.0F;  ///< of the ink, from the middle of the line

    explicit Nearness(const StrokeInk& ink)
        : line_half(static_cast<float>(ink.line_half)),
          reach(static_cast<float>(std::max(ink.line_half, ink.halo_half)) + 0.5F) {}
    std::uint8_t at(float away) const {
        return static_cast<std::uint8_t>(std::max(0.0F, reach - away) * (nearest / reach) + 0.5F);
    }
    /// Where only this part of the line's coverage is meant.
    std::uint8_t at(float away, float part) const {
        const float covered = std::clamp(line_half + 0.5F - away, 0.0F, 1.0F) * part;
        return covered > 0.0F ? at(line_half + 0.5F - covered) : std::uint8_t{0};
    }
};

/// The premultiplied colour for each nearness.
class InkTable {
public:
    InkTable(const StrokeInk& ink, const Nearness& nearness) {
        const float line_alpha = ink.line.alphaF();
        const float halo_alpha = ink.halo.alphaF();
        const std::array<float, 3> line{ink.line.redF(), ink.line.greenF(), ink.line.blueF()};
        const std::array<float, 3> halo{ink.halo.redF(), ink.halo.greenF(), ink.halo.blueF()};
        const auto halo_half = static_cast<float>(ink.halo_half);
        for (std::size_t i = 1; i < colours_.size(); ++i) {
            const float away = nearness.reach * (1.0F - static_cast<float>(i) / nearest);
            const float over = 255.0F * line_alpha * std::min(1.0F, std::max(0.0F, nearness.line_half + 0.5F - away));
            const float under = halo_alpha * std::min(1.0F, std::max(0.0F, halo_half + 0.5F - away)) * (255.0F - over);
            const auto mixed = [&](float a, float b) { return static_cast<int>(a * over + b * under + 0.5F); };
            colours_[i] =
                qRgba(mixed(line[0], halo[0]), mixed(line[1], halo[1]), mixed(line[2], halo[2]), mixed(1.0F, 1.0F));
        }
    }
    QRgb operator[](std::uint8_t nearness) const { return colours_[nearness]; }

private:
    std::array<QRgb, 256> colours_{};
};

/// A leg as it is painted, from the middle of a pixel.
struct Leg {
    float x, y;    ///< where it begins
    float ux, uy;  ///< its direction
    float length;
    float begin, end;              ///< along it, what it covers
    float whole_begin, whole_end;  ///< and covers wholly
    float opacity;
    bool goes_on_after;
    float left, right, top, bottom;  ///< of its box, as far as ink reaches

    Leg(const StrokeLeg& leg, float reach)
        : x(static_cast<float>(leg.from.x()) - 0.5F),
          y(static_cast<float>(leg.from.y()) - 0.5F),
          opacity(static_cast<float>(leg.opacity)),
          goes_on_after(leg.goes_on_after) {
        const auto dx = static_cast<float>(leg.to.x() - leg.from.x());
        const auto dy = static_cast<float>(leg.to.y() - leg.from.y());
        length = std::sqrt(dx * dx + dy * dy);
        ux = length > 0.0F ? dx / length : 1.0F;
        uy = length > 0.0F ? dy / length : 0.0F;
        // A joint is covered by the leg before it, a dot by its only one.
        const bool dot = length == 0.0F;
        begin = dot ? -reach : leg.goes_on_before ? 0.0F : -0.5F;
        whole_begin = leg.goes_on_before ? 0.0F : 0.5F;
        end = goes_on_after ? length + reach : length + 0.5F;
        whole_end = goes_on_after ? length : length - 0.5F;
        left = std::min(x, x + dx) - reach;
        right = std::max(x, x + dx) + reach;
        top = std::min(y, y + dy) - reach;
        bottom = std::max(y, y + dy) + reach;
    }
};

class Tile {
public:
    explicit Tile(QPoint corner) : x_(static_cast<float>(corner.x())), y_(static_cast<float>(corner.y())) {}

    bool isTouchedBy(const Leg& leg) const {
        return leg.right >= x_ && leg.left < x_ + tile_px && leg.bottom >= y_ && leg.top < y_ + tile_px;
    }
    void add(const Leg& leg, const Nearness& nearness);
    /// Writes the pixels of the part where something was added, and returns that part.
    QRect ink(QImage& picture, const InkTable& table) const;

private:
    using Row = std::array<std::uint8_t, tile_px>;

    float x_, y_;
    int left_ = tile_px, right_ = -1, top_ = tile_px, bottom_ = -1;  ///< of what was added
    std::array<Row, tile_px> rows_{};
};

void Tile::add(const Leg& leg, const Nearness& nearness) {
    const float x0 = leg.x - x_;
    const float y0 = leg.y - y_;
    const float per_across = std::abs(leg.uy) > least_slope ? 1.0F / leg.uy : 0.0F;
    const float per_along = std::abs(leg.ux) > least_slope ? 1.0F / leg.ux : 0.0F;
    const int top = std::max(0, static_cast<int>(std::ceil(leg.top - y_)));
    const int bottom = std::min(tile_px - 1, static_cast<int>(std::floor(leg.bottom - y_)));
    for (int y = top; y <= bottom; ++y) {
        const float down = static_cast<float>(y) - y0;
        float from = leg.left - x_;
        float to = leg.right - x_;
        const auto keep = [&](float a, float b) {
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        };
        if (per_across != 0.0F)
            keep(x0 + (down * leg.ux - nearness.reach) * per_across,
                 x0 + (down * leg.ux + nearness.reach) * per_across);
        if (per_along != 0.0F)
            keep(x0 + (leg.begin - down * leg.uy) * per_along, x0 + (leg.end - down * leg.uy) * per_along);
        const int left = from > 0.0F ? static_cast<int>(std::ceil(from)) : 0;
        const int right = to < tile_px - 1 ? static_cast<int>(std::floor(to)) : tile_px - 1;
        if (left > right) continue;
        left_ = std::min(left_, left);
        right_ = std::max(right_, right);
        top_ = std::min(top_, y);
        bottom_ = std::max(bottom_, y);
        Row& row = rows_[static_cast<std::size_t>(y)];
        for (int x = left; x <= right; ++x) {
            const float aside = static_cast<float>(x) - x0;
            const float along = aside * leg.ux + down * leg.uy;
            const float away = std::abs(down * leg.ux - aside * leg.uy);
            std::uint8_t& pixel = row[static_cast<std::size_t>(x)];
            const float beyond = std::max(-along, along - leg.length);
            float distance = away;
            float part = leg.opacity;
            if (along < leg.whole_begin || along > leg.whole_end) {
                if (leg.length == 0.0F || (leg.goes_on_after && beyond == along - leg.length))
                    distance = std::sqrt(away * away + beyond * beyond);
                else
                    part *= std::clamp(0.5F - beyond, 0.0F, 1.0F);
            }
            pixel = std::max(pixel, part == 1.0F ? nearness.at(distance) : nearness.at(distance, part));
        }
    }
}

QRect Tile::ink(QImage& picture, const InkTable& table) const {
    const qsizetype stride = picture.bytesPerLine() / static_cast<qsizetype>(sizeof(QRgb));
    auto* const pixels = reinterpret_cast<QRgb*>(picture.bits());
    for (int y = top_; y <= bottom_; ++y) {
        QRgb* const line = pixels + y * stride;
        const Row& row = rows_[static_cast<std::size_t>(y)];
        std::fill(line + left_, line + right_ + 1, 0U);
        for (std::size_t x = 0; x < tile_px; x += sizeof(std::uint64_t)) {
            std::uint64_t several = 0;
            std::memcpy(&several, &row[x], sizeof(several));
            if (several == 0) continue;
            for (std::size_t i = x; i < x + sizeof(several); ++i)
                if (row[i] > 0) line[i] = table[row[i]];
        }
    }
    return {QPoint(left_, top_), QPoint(right_, bottom_)};
}

}  // namespace

void paintStroke(QPainter& painter, const std::vector<StrokeLeg>& legs, const StrokeInk& ink) {
    const DevicePixels pixels(painter);
    const QRectF visible = pixels.visible();
    const Nearness nearness(ink);
    std::vector<Leg> near;
    near.reserve(legs.size());
    QRectF box;
    for (const StrokeLeg& leg : legs) {
        const Leg prepared(leg, nearness.reach);
        // What is not known compares as false.
        if (!(prepared.right >= visible.left() && prepared.left <= visible.right() &&
              prepared.bottom >= visible.top() && prepared.top <= visible.bottom()))
            continue;
        near.push_back(prepared);
        box |= QRectF(QPointF(prepared.left, prepared.top), QPointF(prepared.right, prepared.bottom));
    }
    if (near.empty()) return;
    const QRect all = (box & visible).toAlignedRect();
    const InkTable table(ink, nearness);
    QImage picture(tile_px, tile_px, QImage::Format_ARGB32_Premultiplied);
    for (int y = all.top(); y <= all.bottom(); y += tile_px)
        for (int x = all.left(); x <= all.right(); x += tile_px) {
            Tile tile({x, y});
            for (const Leg& leg : near)
                if (tile.isTouchedBy(leg)) tile.add(leg, nearness);
            const QRect part = tile.ink(picture, table);
            if (part.isValid()) painter.drawImage(QPoint(x, y) + part.topLeft(), picture, part);
        }
}

}  // namespace echotrail
