// The states of the answers: coordinates, rates and efforts as elsewhere, then accelerations, a direction
// (coordinates on the tangent, rates, efforts) and weights of the accelerations. See the README.
#pragma once

struct places {
    size_t rates, efforts, accelerations, direction, weights, all;
};

static struct places places_of(size_t coordinates, size_t rates) {
    struct places places;
    places.rates = coordinates;
    places.efforts = places.rates + rates;
    places.accelerations = places.efforts + rates;
    places.direction = places.accelerations + rates;
    places.weights = places.direction + 3 * rates;
    places.all = places.weights + rates;
    return places;
}
