#include "ui/views/stroke_tiles.hpp"

#include "ui/views/device_pixels.hpp"

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace echotrail {
namespace {

/// Pixels are worked on in squares of this side: what is between the lines of a large shape costs nothing.
constexpr int tile_px = 32;
/// In a row as many are worked on at once, without branches: vector instructions do it.
constexpr int group_px = 8;
constexpr float nearest = 255.0F;  ///< on the middle of a line
constexpr float least_slope = 1e-4F;
constexpr float far = 1e9F;    ///< no end lies there
constexpr float steep = 1e9F;  ///< any coverage times this is more than ink reaches

/// How near a pixel lies to a line, as it is kept: 0 is as far as ink reaches, or farther.
struct Nearness {
    float line_half = 0.5F;
    float reach = 1.0F;  ///< of the ink, from the middle of the line

    explicit Nearness(const StrokeInk& ink)
        : line_half(static_cast<float>(ink.line_half)),
          reach(static_cast<float>(std::max(ink.line_half, ink.halo_half)) + 0.5F) {}
    /// Where only `part` of the line is meant, that of what has as much coverage; there is no halo then.
    std::int32_t at(float away, float part) const {
        const float covered = std::min(1.0F, std::max(0.0F, line_half + 0.5F - away)) * part;
        const float as_near = std::min(reach - line_half - 0.5F + covered, covered * steep);
        const float whole = std::max(0.0F, reach - away);
        return static_cast<std::int32_t>((part == 1.0F ? whole : as_near) * (nearest / reach) + 0.5F);
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
        for (int i = 1; i < 256; ++i) {
            const float away = nearness.reach * (1.0F - static_cast<float>(i) / nearest);
            const float over = 255.0F * line_alpha * std::min(1.0F, std::max(0.0F, nearness.line_half + 0.5F - away));
            const float under = halo_alpha * std::min(1.0F, std::max(0.0F, halo_half + 0.5F - away)) * (255.0F - over);
            const auto mixed = [&](float a, float b) { return static_cast<int>(a * over + b * under + 0.5F); };
            colours_[static_cast<std::size_t>(i)] =
                qRgba(mixed(line[0], halo[0]), mixed(line[1], halo[1]), mixed(line[2], halo[2]), mixed(1.0F, 1.0F));
        }
    }
    QRgb operator[](std::int32_t nearness) const { return colours_[static_cast<std::size_t>(nearness)]; }

private:
    std::array<QRgb, 256> colours_{};
};

/// A leg as it is painted, from the middle of a pixel.
struct Leg {
    float x, y;    ///< where it begins
    float ux, uy;  ///< its direction
    float length;
    float begin;                     ///< along it; a joint is covered by the leg before it
    float round_begin, round_end;    ///< where its ends are rounded off
    float square_begin, square_end;  ///< and where they are cut off
    float square_until;              ///< nearer to a rounded end the cut of the beginning does not show
    float opacity;
    float left, right, top, bottom;  ///< of its box, as far as ink reaches

    Leg(const StrokeLeg& leg, float reach)
        : x(static_cast<float>(leg.from.x()) - 0.5F),
          y(static_cast<float>(leg.from.y()) - 0.5F),
          opacity(static_cast<float>(leg.opacity)) {
        const auto dx = static_cast<float>(leg.to.x() - leg.from.x());
        const auto dy = static_cast<float>(leg.to.y() - leg.from.y());
        length = std::sqrt(dx * dx + dy * dy);
        ux = length > 0.0F ? dx / length : 1.0F;
        uy = length > 0.0F ? dy / length : 0.0F;
        const bool dot = length == 0.0F;  // covered by its only leg
        begin = leg.goes_on_before && !dot ? 0.0F : -far;
        round_begin = dot ? 0.0F : -far;
        round_end = leg.goes_on_after ? length : far;
        square_begin = leg.goes_on_before ? -far : 0.0F;
        square_end = leg.goes_on_after ? far : length;
        square_until = leg.goes_on_after ? 0.5F * length : far;
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
    using Row = std::array<std::int32_t, tile_px>;

    /// Adds to the pixels of a group, the first of which lies so far from the leg's beginning.
    static void addGroup(Row::iterator pixels, Leg leg, Nearness nearness, float aside, float down);

    float x_, y_;
    int left_ = tile_px, right_ = -1, top_ = tile_px, bottom_ = -1;  ///< of what was added
    std::array<Row, tile_px> rows_{};
};

void Tile::add(const Leg& leg, const Nearness& nearness) {
    const float x0 = leg.x - x_;
    const float y0 = leg.y - y_;
    // The part of a row within reach of the leg's line, whose ends lie within the leg's box.
    const bool level = std::abs(leg.uy) <= least_slope;
    const float right_per_row = level ? 0.0F : leg.ux / leg.uy;
    const float half = level ? far : nearness.reach / std::abs(leg.uy);
    const float box_left = std::max(0.0F, leg.left - x_);
    const float box_right = std::min(tile_px - 1.0F, leg.right - x_);
    const int top = std::max(0, static_cast<int>(std::ceil(leg.top - y_)));
    const int bottom = std::min(tile_px - 1, static_cast<int>(std::floor(leg.bottom - y_)));
    for (int y = top; y <= bottom; ++y) {
        const float down = static_cast<float>(y) - y0;
        const float middle = x0 + down * right_per_row;
        const float from = std::max(box_left, middle - half);
        const float to = std::min(box_right, middle + half);
        if (from > to) continue;
        const int left = static_cast<int>(from);
        const int right = static_cast<int>(to);
        left_ = std::min(left_, left);
        right_ = std::max(right_, right);
        top_ = std::min(top_, y);
        bottom_ = std::max(bottom_, y);
        const auto row = rows_[static_cast<std::size_t>(y)].begin();
        for (int x = left - left % group_px; x <= right; x += group_px)
            addGroup(row + x, leg, nearness, static_cast<float>(x) - x0, down);
    }
}

void Tile::addGroup(Row::iterator pixels, Leg leg, Nearness nearness, float aside, float down) {
    for (int i = 0; i < group_px; ++i) {
        const float right = aside + static_cast<float>(i);
        const float along = right * leg.ux + down * leg.uy;
        const float away = std::abs(down * leg.ux - right * leg.uy);
        const float beyond = std::max(leg.round_begin - along, std::max(0.0F, along - leg.round_end));
        const float distance = std::sqrt(away * away + beyond * beyond);
        const float before = along < leg.square_until ? leg.square_begin - along : -far;
        const float cut = std::max(before, along - leg.square_end);
        const float part = leg.opacity * std::min(1.0F, std::max(0.0F, 0.5F - cut));
        pixels[i] = std::max(pixels[i], nearness.at(distance, along >= leg.begin ? part : 0.0F));
    }
}

QRect Tile::ink(QImage& picture, const InkTable& table) const {
    const qsizetype stride = picture.bytesPerLine() / static_cast<qsizetype>(sizeof(QRgb));
    auto* const pixels = reinterpret_cast<QRgb*>(picture.bits());
    for (int y = top_; y <= bottom_; ++y) {
        QRgb* const line = pixels + y * stride;
        const Row& row = rows_[static_cast<std::size_t>(y)];
        for (int x = left_; x <= right_; ++x) line[x] = table[row[static_cast<std::size_t>(x)]];
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
