#include "core/evaluation/svg.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace echotrail {
namespace {

constexpr std::string_view grid_style = "stroke:#ddd";
constexpr double axis_title_distance = 40.0;

std::string px(double value) { return fixedText(value, 1); }

std::string attribute(std::string_view name, std::string_view value) {
    std::string text(" ");
    text.append(name).append("=\"").append(value).append("\"");
    return text;
}

std::string styled(std::string_view style) { return style.empty() ? std::string() : attribute("style", style); }

}  // namespace

std::string fixedText(double number, int decimals) {
    std::array<char, 400> text{};
    const auto done = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, decimals);
    std::string result(text.data(), done.ptr);
    const bool zero = result.find_first_not_of("-0.") == std::string::npos;
    if (zero && result.front() == '-') result.erase(0, 1);
    return result;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

SvgAxis::SvgAxis(double low, double high, double from, double to) : low_(low), high_(high), from_(from), to_(to) {
    if (!(high_ > low_)) high_ = low_ + 1;
}

double SvgAxis::step(int about) const {
    const double rough = (high_ - low_) / about, power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double round : {1.0, 2.0, 5.0})
        if (round * power >= 0.999 * rough) return round * power;
    return 10 * power;
}

std::vector<double> SvgAxis::marks(int about) const {
    const double by = step(about);
    std::vector<double> values;
    for (double k = std::ceil(low_ / by - 1e-9); k * by <= high_ + 1e-9 * by; ++k) values.push_back(k * by);
    return values;
}

int SvgAxis::decimals(int about) const {
    return std::max(0, static_cast<int>(-std::floor(std::log10(step(about)) + 1e-9)));
}

SvgDrawing::SvgDrawing(double width, double height, std::string_view name) {
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"";
    text_ += attribute("viewBox", "0 0 " + px(width) + " " + px(height)) + attribute("width", px(width)) +
             attribute("aria-label", escaped(name)) + ">\n";
}

void SvgDrawing::line(Point from, Point to, std::string_view style) {
    text_ += "<line" + attribute("x1", px(from.x)) + attribute("y1", px(from.y)) + attribute("x2", px(to.x)) +
             attribute("y2", px(to.y)) + styled(style) + "/>\n";
}

void SvgDrawing::polyline(const std::vector<Point>& points, std::string_view style) {
    if (points.size() < 2) return;
    std::string places;
    for (const Point& point : points) {
        if (!places.empty()) places += ' ';
        places.append(px(point.x)).append(",").append(px(point.y));
    }
    text_ += "<polyline fill=\"none\"" + attribute("points", places) + styled(style) + "/>\n";
}

void SvgDrawing::box(Point corner, double width, double height, std::string_view style, std::string_view hint) {
    text_ += "<rect" + attribute("x", px(corner.x)) + attribute("y", px(corner.y)) + attribute("width", px(width)) +
             attribute("height", px(std::max(0.0, height))) + styled(style);
    if (hint.empty())
        text_ += "/>\n";
    else
        text_ += "><title>" + escaped(hint) + "</title></rect>\n";
}

void SvgDrawing::circle(Point centre, double radius, std::string_view style) {
    text_ += "<circle" + attribute("cx", px(centre.x)) + attribute("cy", px(centre.y)) + attribute("r", px(radius)) +
             styled(style) + "/>\n";
}

void SvgDrawing::cross(Point c, double reach, std::string_view style) {
    line({c.x - reach, c.y - reach}, {c.x + reach, c.y + reach}, style);
    line({c.x - reach, c.y + reach}, {c.x + reach, c.y - reach}, style);
}

void SvgDrawing::text(Point place, std::string_view words, Anchor anchor, std::string_view style) {
    const char* const anchors[] = {"start", "middle", "end"};
    text_ += "<text" + attribute("x", px(place.x)) + attribute("y", px(place.y)) +
             attribute("text-anchor", anchors[static_cast<int>(anchor)]) + styled(style) + ">" + escaped(words) +
             "</text>\n";
}

void SvgDrawing::uprightText(Point place, std::string_view words) {
    text_ += "<text text-anchor=\"middle\"" +
             attribute("transform", "translate(" + px(place.x) + " " + px(place.y) + ") rotate(-90)") + ">" +
             escaped(words) + "</text>\n";
}

void SvgDrawing::leftAxis(const SvgAxis& axis, double left, double right, std::string_view title, int about) {
    for (const double mark : axis.marks(about)) {
        const double y = axis.at(mark);
        line({left, y}, {right, y}, grid_style);
        text({left - 6, y + 4}, fixedText(mark, axis.decimals(about)), Anchor::End);
    }
    uprightText({left - axis_title_distance, (axis.at(axis.low()) + axis.at(axis.high())) / 2}, title);
}

void SvgDrawing::bottomAxis(const SvgAxis& axis, double top, double bottom, std::string_view title, int about) {
    for (const double mark : axis.marks(about)) {
        const double x = axis.at(mark);
        line({x, top}, {x, bottom}, grid_style);
        text({x, bottom + 16}, fixedText(mark, axis.decimals(about)), Anchor::Middle);
    }
    text({(axis.at(axis.low()) + axis.at(axis.high())) / 2, bottom + 34}, title, Anchor::Middle);
}

}  // namespace echotrail
