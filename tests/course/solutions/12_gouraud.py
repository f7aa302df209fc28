import numpy as np


def twice_area(A, B, C):
    return (B[0] - A[0]) * (C[1] - A[1]) - (B[1] - A[1]) * (C[0] - A[0])


def weights(P, triangle):
    A, B, C = triangle
    areas = np.array([twice_area(P, B, C), twice_area(A, P, C), twice_area(A, B, P)])
    return areas / twice_area(A, B, C)


def gouraud(P, triangle, intensities):
    colors = np.clip(intensities, 0, 1)
    return weights(P, triangle) @ colors


def picture(triangle, intensities, width, height):
    image = np.zeros((height, width, 3))
    for row in range(height):
        for column in range(width):
            P = np.array([column + 0.5, row + 0.5])
            if min(weights(P, triangle)) >= 0:
                image[row, column] = gouraud(P, triangle, intensities)
    return image
