#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What drawings in a page are made of: numbers as text, an axis, shapes.
namespace echotrail {

/// With a decimal point whatever the locale; "-0" becomes "0".
std::string fixedText(double number, int decimals);
/// Made harmless for text and attributes of HTML and SVG.
std::string escaped(std::string_view text);

/// A scale from values to places in a drawing, with round marks.
class SvgAxis {
public:
    /// Values from `low` to `high` (made a little longer where they are the same) lie at `from` to `to`.
    SvgAxis(double low, double high, double from, double to);
    double at(double value) const { return from_ + (value - low_) / (high_ - low_) * (to_ - from_); }
    double low() const { return low_; }
    double high() const { return high_; }
    /// About so many values of 1, 2 or 5 times a power of ten.
    std::vector<double> marks(int about = 5) const;
    /// Decimals that tell marks apart.
    int decimals(int about = 5) const;

private:
    double step(int about) const;
    double low_, high_, from_, to_;
};

class SvgDrawing {
public:
    struct Point {
        double x = 0.0, y = 0.0;
    };

    /// In pixels at the page's usual size; `name` is read out to those who do not see it.
    SvgDrawing(double width, double height, std::string_view name);

    void line(Point from, Point to, std::string_view style);
    void polyline(const std::vector<Point>& points, std::string_view style);
    /// `hint` is shown when the pointer rests on it; may be empty.
    void box(Point corner, double width, double height, std::string_view style, std::string_view hint = {});
    void circle(Point centre, double radius, std::string_view style);
    void cross(Point centre, double reach, std::string_view style);
    enum class Anchor { Start, Middle, End };
    void text(Point place, std::string_view words, Anchor anchor = Anchor::Start, std::string_view style = {});
    /// Upwards, about `place`.
    void uprightText(Point place, std::string_view words);

    /// Grid lines and numbers of a vertical axis at its left, and what it measures.
    void leftAxis(const SvgAxis& axis, double left, double right, std::string_view title, int about = 5);
    /// Numbers of a horizontal axis below `bottom`, grid lines up to `top`, and what it measures.
    void bottomAxis(const SvgAxis& axis, double top, double bottom, std::string_view title, int about = 8);

    std::string finish() const { return text_ + "</svg>\n"; }

private:
    std::string text_;
};

}  // namespace echotrail
