#pragma once

#include "core/base/parameters.hpp"

/// Clang before 17 does not find by itself what an aggregate's initialisers say of its type.
namespace echotrail {

template <class Owner, class Value, class... Rest>
Field(Value Owner::*, Rest...) -> Field<Owner, Value>;
template <class Owner, class Enum, std::size_t N, class... Rest>
ChoiceField(Enum Owner::*, std::string_view, std::array<std::string_view, N>, Rest...) -> ChoiceField<Owner, Enum, N>;

}  // namespace echotrail
