-- tries to replace the world
-- expect: error
world = nil
