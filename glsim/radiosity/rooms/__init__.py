"""Built-in rooms, a file each, of our own geometry: planar polygons, in metres, y upwards.

shapes     beams, pipes, walls with openings, stairs, turned bodies
surfaces   textures of materials: bricks, concrete, boards, terrazzo
paintings  textures of pictures
factory, museum    the rooms
"""
