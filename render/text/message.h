#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace vitrine {

/// Returns the number of placeholders {1} to {9} in a text, if they are numbered without a gap; else -1.
[[nodiscard]] constexpr int placesIn(std::string_view text)
{
    unsigned found = 0;
    for (std::size_t i = 0; i + 2 < text.size(); ++i)
        if (text[i] == '{' && text[i + 1] >= '1' && text[i + 1] <= '9' && text[i + 2] == '}')
            found |= 1U << static_cast<unsigned>(text[i + 1] - '1');
    int count = 0;
    for (; (found & 1U) != 0; found >>= 1U) ++count;
    return found == 0 ? count : -1;
}

/// English text of a message: a literal whose placeholders fit the arguments, which the compiler checks.
template <class... Arguments> struct MessageText {
    template <std::size_t n> consteval MessageText(const char (&literal)[n]) : text(literal, n - 1)
    {
        if (placesIn(text) != static_cast<int>(sizeof...(Arguments))) throw "the placeholders do not fit the arguments";
    }
    std::string_view text;
};

/// Text for people, which can be shown in every language: an English text with placeholders {1} to {9}, and their
/// arguments. Made by `message` where the text is written; `english` gives the text of files and logs, `translated`
/// (render/text/translation.h) that of the window.
///
///     throw Failure(ErrorKind::file, message("Cannot read {1}: {2}", path, why));
///
/// The extraction (assets/translations/update.py) finds the literal by the name `message`.
class Message {
public:
    Message() = default;
    /// A finished English text of code that does not use `message` yet.
    Message(std::string text) : text_(std::move(text)), kind_(Kind::unmarked) {}
    Message(std::string_view text) : Message(std::string(text)) {}
    Message(const char* text) : Message(std::string(text)) {}
    /// A text that is the same in every language: a name, path, number, typed text, or message of another library.
    [[nodiscard]] static Message verbatim(std::string text) { return {std::move(text), Kind::verbatim}; }
    /// An English text that stands in a table (label, group, help, choice) and is extracted there.
    [[nodiscard]] static Message ofTable(std::string_view text) { return {std::string(text), Kind::marked}; }

    [[nodiscard]] bool empty() const { return text().empty(); }
    /// Returns the English text, with the arguments in their places.
    [[nodiscard]] std::string english() const;
    /// Returns whether neither the text nor an argument is a finished text, which would have to be recognized.
    [[nodiscard]] bool isMarked() const;

    /// Compares the English texts.
    friend bool operator==(const Message& a, const Message& b) { return a.english() == b.english(); }
    friend bool operator<(const Message& a, const Message& b) { return a.english() < b.english(); }
    friend std::ostream& operator<<(std::ostream&, const Message&);

private:
    enum class Kind { marked, unmarked, verbatim };
    Message(std::string text, Kind kind) : text_(std::move(text)), kind_(kind) {}
    /// Returns the text with its placeholders.
    [[nodiscard]] std::string_view text() const { return literal_.empty() ? std::string_view(text_) : literal_; }

    template <class... Arguments>
    friend Message message(MessageText<std::type_identity_t<Arguments>...>, Arguments&&...);
    friend class Catalog;

    template <class Argument> [[nodiscard]] static Message argument(Argument&& value)
    {
        using Plain = std::remove_cvref_t<Argument>;
        static_assert(!std::is_floating_point_v<Plain>, "give the number as text, with its digits and unit");
        if constexpr (std::is_same_v<Plain, Message>)
            return std::forward<Argument>(value);
        else if constexpr (std::is_same_v<Plain, std::filesystem::path>)
            return verbatim(value.string());
        else if constexpr (std::is_integral_v<Plain> && !std::is_same_v<Plain, char> && !std::is_same_v<Plain, bool>)
            return verbatim(std::to_string(value));
        else if constexpr (std::is_same_v<Plain, char>)
            return verbatim(std::string(1, value));
        else
            return verbatim(std::string(std::forward<Argument>(value)));
    }

    std::string_view literal_;  ///< The literal of `message`, which lives as long as the program; else `text_`.
    std::string text_;
    std::vector<Message> arguments_;
    Kind kind_ = Kind::verbatim;
};

/// Makes a message of a literal and its arguments: texts, paths and integers are shown as they are, messages are
/// translated.
template <class... Arguments>
[[nodiscard]] Message message(MessageText<std::type_identity_t<Arguments>...> text, Arguments&&... arguments)
{
    Message made;
    made.literal_ = text.text;
    made.kind_ = Message::Kind::marked;
    made.arguments_.reserve(sizeof...(Arguments));
    (made.arguments_.push_back(Message::argument(std::forward<Arguments>(arguments))), ...);
    return made;
}

/// Returns the text with each placeholder {1} to {9}, also written {=1}, replaced by the text of its place.
[[nodiscard]] std::string withPlaces(std::string_view text, const std::vector<std::string>& places);

}  // namespace vitrine
