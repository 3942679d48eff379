//! Structures in balance, against the numbers of the literature.
use ga_design::tensegrity::{Analysis, Hand, Octahedron, Polyhedron, Prism, Solid, Tower};

#[test]
fn experiment() {
    let s = Octahedron::default().structure().unwrap();
    let a = Analysis::of(&s).unwrap();
    println!("oct {} {} {} {:?} states {} mech {} null {} res {:e} {:?}", s.nodes().len(), s.struts().count(), s.cables().count(), a.stability, a.states, a.mechanisms, a.nullity, a.residual(&s), &a.force_densities[5..8]);
    let s = Octahedron{ratio:0.65,..Default::default()}.structure().unwrap();
    let a = Analysis::of(&s).unwrap();
    println!("oct .65 {:?} {} {}", a.stability, a.states, a.mechanisms);
    for n in 3..=12 { for hand in [Hand::Left, Hand::Right] {
        let s = Prism{struts:n, hand, ..Default::default()}.structure().unwrap();
        let a = Analysis::of(&s).unwrap();
        println!("prism {n} {} {} {} {:?} states {} mech {} null {} res {:e} {:?}", s.nodes().len(), s.struts().count(), s.cables().count(), a.stability, a.states, a.mechanisms, a.nullity, a.residual(&s), [a.force_densities[0], a.force_densities[n], a.force_densities[2*n]]);
    }}
    for (struts, stages) in [(3,2),(3,3),(3,4),(3,5),(3,8),(4,2),(4,4),(5,3),(6,3)] { for hand in [Hand::Left, Hand::Right] {
        let t = std::time::Instant::now();
        match (Tower{struts, stages, hand, ..Default::default()}).structure() { Err(e) => println!("{struts} {stages} {e}"), Ok(s) => {
        let a = Analysis::of(&s).unwrap();
        println!("tower {struts} {stages} {} {} {} {:?} states {} mech {} null {} res {:e} {:?} free {} {:?}", s.nodes().len(), s.struts().count(), s.cables().count(), a.stability, a.states, a.mechanisms, a.nullity, a.residual(&s), a.eigenvalues.first(), s.has_free_struts(), t.elapsed()); }}
    }}
    for solid in Solid::ALL {
        let t = std::time::Instant::now();
        let s = Polyhedron::of(solid).structure();
        let s = match s { Ok(s) => s, Err(e) => { println!("{} {e}", solid.name()); continue; } };
        let a = Analysis::of(&s).unwrap();
        let c: Vec<_> = s.cables().collect();
        println!("{} {} {} {} {:?} states {} mech {} null {} res {:e} q {:?} {:?} len {} {} min {:?} t {:?} free {}", solid.name(), s.nodes().len(), s.struts().count(), s.cables().count(), a.stability, a.states, a.mechanisms, a.nullity, a.residual(&s), a.force_densities.iter().copied().fold(0.0,f64::max),a.force_densities.last(), s.length(c[0]), s.length(c[c.len()-1]), a.eigenvalues.first(), t.elapsed(), s.has_free_struts());
    }
}
