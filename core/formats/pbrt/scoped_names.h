#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace etalon::pbrt {

/// Names that are valid up to the end of the block in which they were defined. Time and memory are
/// proportional to the definitions, however deep the blocks are nested.
template <class T>
class ScopedNames {
  public:
    /// Returns the value of a name; null if it is unknown.
    const T* find(const std::string& name) const {
        const auto found = values_.find(name);
        return found != values_.end() ? &found->second : nullptr;
    }

    /// Defines a name in the current block. Returns whether the name was known.
    bool define(const std::string& name, T value) {
        const auto [entry, is_new] = values_.try_emplace(name);
        earlier_.emplace_back(name,
                              is_new ? std::nullopt : std::optional<T>(std::move(entry->second)));
        entry->second = std::move(value);
        return !is_new;
    }

    /// Begins a block; the result is needed to end it.
    std::size_t begin_block() const { return earlier_.size(); }

    void end_block(std::size_t begun) {
        for (; earlier_.size() > begun; earlier_.pop_back()) {
            auto& [name, value] = earlier_.back();
            if (value) {
                values_[name] = std::move(*value);
            } else {
                values_.erase(name);
            }
        }
    }

    /// Returns the known names, in no particular order.
    std::vector<std::string_view> names() const {
        std::vector<std::string_view> list;
        for (const auto& [name, value] : values_) list.push_back(name);
        return list;
    }

  private:
    std::unordered_map<std::string, T> values_;
    std::vector<std::pair<std::string, std::optional<T>>> earlier_;  ///< what definitions replaced
};

}  // namespace etalon::pbrt
