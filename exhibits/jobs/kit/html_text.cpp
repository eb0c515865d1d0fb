#include "exhibits/jobs/kit/html_text.h"

#include "render/files/strict_json.h"
#include "render/text/escaped.h"

#include <charconv>
#include <cmath>

namespace vitrine::jobs {
namespace {

constexpr const char* pageStart = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>@TITLE@</title>
<style>
:root { color-scheme: light; --ground: #f1efeb; --sheet: #fbfaf8; --text: #2a2825; --dim: #6d685f; --accent: #9a5f14; --line: #ddd8cf; }
* { box-sizing: border-box; }
[hidden] { display: none !important; }
body { margin: 0 auto; max-width: 1320px; padding: 24px; background: var(--ground); color: var(--text); font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 24px; font-weight: 600; margin: 0 0 4px; }
p { margin: 4px 0; max-width: 80ch; }
.dim { color: var(--dim); }
.law { font-size: 18px; margin: 12px 0; }
.sheet { background: var(--sheet); border: 1px solid var(--line); border-radius: 6px; padding: 12px; margin-top: 16px; }
.chart { position: relative; }
.chart > svg { display: block; width: 100%; height: auto; }
.chart > svg.spots { position: absolute; inset: 0; height: 100%; }
.spots circle { fill: transparent; stroke: transparent; stroke-width: 2; cursor: pointer; }
.spots circle:hover, .spots circle.on { stroke: var(--accent); }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(320px, 1fr)); gap: 12px; }
figure { margin: 0; }
figcaption { color: var(--dim); margin-top: 4px; }
.wipe { position: relative; overflow: hidden; cursor: ew-resize; background: #000; touch-action: none; }
.wipe img, figure > img { display: block; width: 100%; image-rendering: pixelated; background: #000; }
.wipe img.over { position: absolute; inset: 0; height: 100%; }
.wipe i { position: absolute; top: 0; bottom: 0; width: 2px; background: var(--accent); }
nav { display: flex; flex-wrap: wrap; gap: 8px; margin-bottom: 12px; }
button { font: inherit; color: inherit; background: none; border: 1px solid var(--line); border-radius: 4px; padding: 2px 10px; cursor: pointer; }
button.on { border-color: var(--accent); color: var(--accent); }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 4px 10px; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
tbody tr { cursor: pointer; }
tbody tr:hover, tbody tr.on { background: #f3ead9; }
tr.dominated { color: var(--dim); }
.scroll { overflow-x: auto; }
</style>
</head>
<body>
)page";

}  // namespace

std::string with(std::string text, const std::string& word, const std::string& replacement)
{
    return text.replace(text.find(word), word.size(), replacement);
}

std::string pageNumber(double x, int digits)
{
    if (!std::isfinite(x)) return "–";
    char text[40];
    return std::string(text, std::to_chars(text, text + sizeof text, x, std::chars_format::general, digits).ptr);
}

std::string scriptJson(const render::Json& json)
{
    std::string text = json.dump();
    for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
        text.replace(at, 2, "<\\/");
    return text;
}

std::string pageHead(const std::string& title)
{
    return with(pageStart, "@TITLE@", escaped(title));
}

}  // namespace vitrine::jobs
