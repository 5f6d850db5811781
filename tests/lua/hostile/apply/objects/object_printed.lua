-- tries to print an address
-- expect: harmless
log(object, world, out, params, store, frame)
