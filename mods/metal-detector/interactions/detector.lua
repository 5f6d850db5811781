-- A coil with an alternating current makes a field that falls with the third power of the distance. In metal it drives
-- a current, which makes a field that falls in the same way until it is back at the coil: together, the sixth power.
--
-- The detector switches nothing itself: it is a source, and the circuit that is wired to it decides from its voltage.
return interaction {
  name = "Electricity <- Metal",
  text = "Gives a detector a voltage for every movable conductor nearby. It falls with the sixth power of the distance: at "
    .. "twice the distance a sixty-fourth is left.",
  calls = "Electricity",
  reads = { "Position", "Conductor", "Fixed" },
  attached = true,
  pairs = { first = { "Position", "Conductor" }, second = { "Position", "Conductor" }, within = "reach" },
  params = {
    voltage = { default = 12, min = 0, max = 1e5, unit = "V", text = "For metal at the nominal distance, or nearer" },
    nominal = { default = 0.3, min = 0.01, max = 100, unit = "m", text = "The distance for which the voltage is stated" },
    reach = { default = 2, min = 0, max = 100, unit = "m", text = "The greatest distance at which it detects metal" },
  },
  apply = function(detector, metal, params, out)
    if metal.Fixed then return end -- fixed metal is part of the calibration
    local distance = (metal.Position.value - detector.Position.value):length()
    local share = params.nominal / math.max(distance, params.nominal)
    local cube = share * share * share
    out.addVoltage(detector, params.voltage * cube * cube)
  end,
}
